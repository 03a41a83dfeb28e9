// SPDX-License-Identifier: MIT
#include "host/apps/report.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/console/print.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {
namespace {

std::filesystem::path data_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
    return data;
  }
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/tmp") / ".local" / "share";
}

}  // namespace

std::filesystem::path run_folder(const std::filesystem::path& chosen) {
  if (!chosen.empty()) {
    return chosen;
  }
  const auto now =
      std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
  const auto milliseconds = now.time_since_epoch().count() % 1000;
  return data_folder() / "echomap" / "runs" /
         fmt::format("{:%Y-%m-%d_%H-%M-%S}-{:03}",
                     fmt::localtime(std::chrono::system_clock::to_time_t(now)),
                     milliseconds);
}

void prepare_outputs(const std::filesystem::path& out, const std::filesystem::path& json) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) {
    throw files::FileError("cannot make the run directory " + out.string() + ": " +
                           error.message() + "\n  next: name another one with --out");
  }
  const files::AtomicFile summary(out / "summary.json");
  if (json.empty() || json == "-") {
    return;
  }
  if (std::filesystem::is_directory(json)) {
    throw files::FileError("cannot write " + json.string() +
                           ": it is a directory\n  next: name a file with --json, or '-'");
  }
  const files::AtomicFile report(json);
}

nlohmann::ordered_json to_json(const evaluation::RunScore& score) {
  nlohmann::ordered_json json;
  json["free_iou"] = score.map.free_iou;
  json["wall_rmse_m"] = nullptr;
  if (score.map.wall_rmse_m) {
    json["wall_rmse_m"] = *score.map.wall_rmse_m;
  }
  json["wall_recall"] = score.map.wall_recall;
  json["ate_rmse_m"] = score.trajectory.ate_rmse_m;
  json["ate_heading_rmse_rad"] = score.trajectory.ate_heading_rmse_rad;
  json["final_error_m"] = score.trajectory.final_error_m;
  json["final_heading_error_rad"] = score.trajectory.final_heading_error_rad;
  json["outline_corners"] = score.outline.corners;
  json["room_corners"] = score.outline.room_corners;
  json["corner_rmse_m"] = nullptr;
  if (score.outline.corner_rmse_m) {
    json["corner_rmse_m"] = *score.outline.corner_rmse_m;
  }
  return json;
}

nlohmann::ordered_json to_json(const evaluation::RelationError& error) {
  return {{"relations", error.relations},
          {"relation_translation_mean_m", error.translation_mean_m},
          {"relation_translation_stddev_m", error.translation_stddev_m},
          {"relation_rotation_mean_rad", error.rotation_mean_rad},
          {"relation_rotation_stddev_rad", error.rotation_stddev_rad}};
}

void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& report) {
  const std::string text = report.dump(2) + "\n";
  if (path == "-") {
    std::fputs(text.c_str(), stdout);
  } else if (!path.empty()) {
    files::write_text_file(path, text);
  }
}

void print_score(const evaluation::RunScore& score) {
  const auto& map = score.map;
  const auto& path = score.trajectory;
  console::print(fmt::format("  free floor agrees    {:5.1f} %  (free_iou)", 100.0 * map.free_iou));
  if (map.wall_rmse_m) {
    console::print(
        fmt::format("  walls are off by     {:5.1f} cm (wall_rmse_m)", 100.0 * *map.wall_rmse_m));
  }
  console::print(
      fmt::format("  walls seen           {:5.1f} %  (wall_recall)", 100.0 * map.wall_recall));
  console::print(
      fmt::format("  the pose is off by  {:5.1f} cm, {:.1f} degrees (ate_rmse_m, heading)",
                  100.0 * path.ate_rmse_m,
                  geometry::degrees(path.ate_heading_rmse_rad)));
}

void print_relation_error(const evaluation::RelationError& error) {
  console::print(
      fmt::format("  {} relations are off by {:.3f} +- {:.3f} m, {:.2f} +- {:.2f} degrees",
                  error.relations,
                  error.translation_mean_m,
                  error.translation_stddev_m,
                  geometry::degrees(error.rotation_mean_rad),
                  geometry::degrees(error.rotation_stddev_rad)));
}

}  // namespace echomap::apps
