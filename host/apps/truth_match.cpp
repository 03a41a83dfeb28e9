// SPDX-License-Identifier: MIT
#include "host/apps/truth_match.hpp"

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
  // Maps on the truths of other bundled rooms: off by 37 to 90 cm, with 4 to 7 % of the walls. The
  // map of a robot that got lost in its own room: 21 cm, 10 %.
  constexpr double kMaxWallErrorM = 0.3;
  constexpr double kMinWallRecall = 0.15;
  const evaluation::MapAgreement& best = score.fitted.map;
  if (best.wall_rmse_m.value_or(0.0) > kMaxWallErrorM && best.wall_recall < kMinWallRecall) {
    throw CommandError(
        ExitCode::kRuntimeError,
        fmt::format("the map of {} does not fit {}, which is of another room, or of another start: "
                    "laid on it as well as can be, its walls are off by {:.0f} cm, and {:.0f} % of "
                    "the true walls are in it\n  next: {}",
                    run.string(),
                    truth.string(),
                    100.0 * *best.wall_rmse_m,
                    100.0 * best.wall_recall,
                    right_command(run, truth)));
  }
}

}  // namespace echomap::apps
