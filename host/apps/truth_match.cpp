// SPDX-License-Identifier: MIT
#include "host/apps/truth_match.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/console/exit_code.hpp"
#include "host/console/shell_line.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using console::CommandError;
using console::ExitCode;

/// The bundled world that a report names; empty where it names none, or a file.
std::string world_in(const fs::path& report) {
  if (!fs::exists(report)) {
    return "";
  }
  const auto json = nlohmann::json::parse(files::read_text_file(report), nullptr, false);
  const auto world = json.is_object() ? json.find("world") : json.end();
  if (world == json.end() || !world->is_string()) {
    return "";
  }
  const auto name = world->get<std::string>();
  return name.ends_with(".toml") || name.find('/') != std::string::npos ? "" : name;
}

/// The next step with the truth that the run itself has written, where it has.
std::string right_command(const fs::path& run, const fs::path& truth) {
  const fs::path own = run / "truth";
  if (fs::exists(own) && !fs::equivalent(own, truth)) {
    return console::shell_line({"echomap", "eval", run.string(), "--truth", own.string()});
  }
  return "name the truth of the same run with --truth: the folder truth that its simulated robot "
         "has written";
}

}  // namespace

RoomMatch match_rooms(const fs::path& run, const fs::path& truth) {
  const std::string driven = world_in(run / "summary.json");
  const std::string true_world = world_in(truth / "truth.json");
  if (driven.empty() || true_world.empty()) {
    return RoomMatch::kUnknown;
  }
  if (driven != true_world) {
    throw CommandError(ExitCode::kUsage,
                       fmt::format("{} is a run in the room '{}', and {} is the truth of '{}'\n"
                                   "  next: {}",
                                   run.string(),
                                   driven,
                                   truth.string(),
                                   true_world,
                                   right_command(run, truth)));
  }
  return RoomMatch::kSame;
}

void refuse_misfit(const fs::path& run, const fs::path& truth, const evaluation::RunScore& score) {
  // Maps on the truths of other bundled rooms have at most 10 % of the walls and 36 % of the floor
  // in common with them. One that a robot has bent in its own room has half of the walls where it
  // began, and more than half of the floor.
  constexpr double kMinWallRecall = 0.15;
  constexpr double kMinFreeIou = 0.5;
  constexpr double kMaxWallErrorM = 0.15;
  const evaluation::MapAgreement& start = score.start.map;
  const evaluation::MapAgreement& fitted = score.fitted.map;
  const double wall_error_m =
      std::min(start.wall_rmse_m.value_or(0.0), fitted.wall_rmse_m.value_or(0.0));
  const double wall_recall = std::max(start.wall_recall, fitted.wall_recall);
  const double free_iou = std::max(start.free_iou, fitted.free_iou);
  if (wall_error_m > kMaxWallErrorM && wall_recall < kMinWallRecall && free_iou < kMinFreeIou) {
    throw CommandError(
        ExitCode::kRuntimeError,
        fmt::format(
            "the map of {} does not fit {}, which is of another room, or of another start: "
            "its walls are off by {:.0f} cm or more, and it has {:.0f} % of the true walls at "
            "most\n  next: {}",
            run.string(),
            truth.string(),
            100.0 * wall_error_m,
            100.0 * wall_recall,
            right_command(run, truth)));
  }
}

}  // namespace echomap::apps
