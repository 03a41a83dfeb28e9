// SPDX-License-Identifier: MIT
#include "host/apps/report.hpp"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/saved_map.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/print.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {
namespace {

std::filesystem::path data_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
    return data;
  }
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/tmp") / ".local" / "share";
}

nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

/// Empty where there is nothing that could have been.
std::optional<double> share_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::nullopt
                    : std::optional(static_cast<double>(part) / static_cast<double>(whole));
}

nlohmann::ordered_json map_json(const evaluation::PlacedScore& score) {
  const auto& [map, obstacles, paths, outline, floor_seen] = score;
  nlohmann::ordered_json json;
  json["free_iou"] = map.free_iou;
  json["floor_seen"] = floor_seen;
  json["wall_rmse_m"] = number_or_null(map.wall_rmse_m);
  json["wall_recall"] = map.wall_recall;
  json["solid_called_free"] = number_or_null(obstacles.solid_called_free);
  json["wall_band_called_free"] = number_or_null(obstacles.wall_band_called_free);
  json["objects"] = obstacles.objects;
  json["objects_found"] = number_or_null(share_of(obstacles.objects_found, obstacles.objects));
  json["path_found_share"] = number_or_null(share_of(paths.paths, paths.pairs));
  json["path_collision_share"] = number_or_null(share_of(paths.collisions, paths.paths));
  return json;
}

/// As "  4.2 %", or a dash for none.
std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:5.1f} %", 100.0 * *share) : "    -  ";
}

/// A line with the score by the first pose and, in brackets, fitted.
void print_shares(const char* label,
                  const std::optional<double>& start,
                  const std::optional<double>& fitted,
                  const char* name) {
  console::print(
      fmt::format("  {:<21}{}  [{}]  ({})", label, percent(start), percent(fitted), name));
}

void print_obstacles(const evaluation::RunScore& score) {
  const auto& start = score.start;
  const auto& fitted = score.fitted;
  print_shares("solid called floor",
               start.obstacles.solid_called_free,
               fitted.obstacles.solid_called_free,
               "solid_called_free");
  print_shares("10 cm behind walls",
               start.obstacles.wall_band_called_free,
               fitted.obstacles.wall_band_called_free,
               "wall_band_called_free");
  print_shares("objects found",
               share_of(start.obstacles.objects_found, start.obstacles.objects),
               share_of(fitted.obstacles.objects_found, fitted.obstacles.objects),
               "objects_found");
  print_shares("paths found",
               share_of(start.paths.paths, start.paths.pairs),
               share_of(fitted.paths.paths, fitted.paths.pairs),
               "path_found_share");
  print_shares("paths that collide",
               share_of(start.paths.collisions, start.paths.paths),
               share_of(fitted.paths.collisions, fitted.paths.paths),
               "path_collision_share");
  console::print(
      fmt::format("  [..]: map laid on the truth, turned by {:.1f} degrees "
                  "(fit_turn_deg); paths for a radius of {:.1f} cm",
                  geometry::degrees(score.fit_turn_rad),
                  100.0 * score.robot_radius_m));
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

bool has_run(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "summary.json");
}

void refuse_to_replace_run(const std::filesystem::path& out, bool may_replace) {
  if (!may_replace && has_run(out)) {
    throw console::CommandError(
        console::ExitCode::kUsage,
        out.string() +
            " has a run in it, which would be overwritten\n  next: name another folder "
            "with --out, or overwrite it with --force");
  }
}

void prepare_outputs(const std::filesystem::path& out,
                     const std::filesystem::path& json,
                     bool may_replace) {
  refuse_to_replace_run(out, may_replace);
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

double radius_of_robot(const std::filesystem::path& run) {
  const auto profile = run / kProfileName;
  return std::filesystem::exists(profile)
             ? session::load_robot_profile(profile.string()).body_radius_m
             : evaluation::kDefaultRobotRadiusM;
}

nlohmann::ordered_json to_json(const evaluation::RunScore& score) {
  nlohmann::ordered_json json = map_json(score.start);
  json["ate_rmse_m"] = score.trajectory.ate_rmse_m;
  json["ate_heading_rmse_rad"] = score.trajectory.ate_heading_rmse_rad;
  json["final_error_m"] = score.trajectory.final_error_m;
  json["final_heading_error_rad"] = score.trajectory.final_heading_error_rad;
  json["outline_corners"] = score.start.outline.corners;
  json["room_corners"] = score.start.outline.room_corners;
  json["corner_rmse_m"] = number_or_null(score.start.outline.corner_rmse_m);
  json["outline_rmse_m"] = number_or_null(score.start.outline.outline_rmse_m);
  json["robot_radius_m"] = score.robot_radius_m;
  json["fit_turn_deg"] = geometry::degrees(score.fit_turn_rad);
  json["fitted"] = map_json(score.fitted);
  json["fitted"]["corner_rmse_m"] = number_or_null(score.fitted.outline.corner_rmse_m);
  json["fitted"]["outline_rmse_m"] = number_or_null(score.fitted.outline.outline_rmse_m);
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
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
      throw files::FileError(std::string("cannot write the report to stdout: ") +
                             std::strerror(errno));
    }
  } else if (!path.empty()) {
    files::write_text_file(path, text);
  }
}

void print_score(const evaluation::RunScore& score) {
  const auto& map = score.start.map;
  const auto& path = score.trajectory;
  print_shares("free floor agrees", map.free_iou, score.fitted.map.free_iou, "free_iou");
  print_shares(
      "floor in reach seen", score.start.floor_seen, score.fitted.floor_seen, "floor_seen");
  if (map.wall_rmse_m) {
    console::print(fmt::format("  walls are off by     {:5.1f} cm [{:5.1f} cm] (wall_rmse_m)",
                               100.0 * *map.wall_rmse_m,
                               100.0 * score.fitted.map.wall_rmse_m.value_or(0.0)));
  }
  print_shares("walls seen", map.wall_recall, score.fitted.map.wall_recall, "wall_recall");
  console::print(
      fmt::format("  the pose is off by  {:5.1f} cm, {:.1f} degrees (ate_rmse_m, heading)",
                  100.0 * path.ate_rmse_m,
                  geometry::degrees(path.ate_heading_rmse_rad)));
  print_obstacles(score);
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
