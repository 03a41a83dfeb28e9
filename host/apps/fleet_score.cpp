// SPDX-License-Identifier: MIT
#include "host/apps/fleet_score.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/fleet_map_files.hpp"
#include "host/apps/report.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using geometry::Pose2;
using nlohmann::ordered_json;

constexpr const char* kTrajectory = "trajectory.tum";

/// How far a robot's last place, as the first robot's map has it, is from the true one.
ordered_json relative_error(const Pose2& T_first_peer,
                            const evaluation::Truth& first,
                            const evaluation::Truth& peer) {
  const Pose2 T_true =
      first.trajectory.front().T_world_robot.inverse() * peer.trajectory.front().T_world_robot;
  const Pose2 T_true_estimated = T_true.inverse() * T_first_peer;
  const Eigen::Vector2d last_m =
      (peer.trajectory.front().T_world_robot.inverse() * peer.trajectory.back().T_world_robot)
          .position_m();
  return {{"position_m", (T_true_estimated * last_m - last_m).norm()},
          {"heading_rad", std::abs(T_true_estimated.heading_rad())}};
}

/// When the last stop of all ended, on the clock that simulated robots have in common.
double last_stop_s(const fleet::FleetState& state) {
  double last_s = 0.0;
  for (const fleet::FleetRobot& robot : state.robots) {
    for (const fleet::FleetMap& map : robot.maps) {
      for (const team_map::Submap& submap : map.record->submaps) {
        last_s = std::max(last_s, submap.end_s);
      }
    }
  }
  return last_s;
}

/// Of topics and payloads that were heard, rounds included; null before the first stop.
ordered_json bytes_per_s_per_robot(const fleet::FleetState& state, std::size_t bytes) {
  const double robot_seconds = static_cast<double>(state.robots.size()) * last_stop_s(state);
  return robot_seconds > 0.0 ? ordered_json(static_cast<double>(bytes) / robot_seconds)
                             : ordered_json();
}

std::optional<evaluation::Truth> truth_of(const fs::path& out, const std::string& robot) {
  try {
    return evaluation::read_truth(out / "truth" / robot);
  } catch (const files::FileError& error) {
    spdlog::warn("no truth of {}: {}", robot, error.what());
    return std::nullopt;
  }
}

/// Its own run against its own truth.
ordered_json trajectory_error(const fs::path& out, const std::string& robot) {
  try {
    return evaluation::score_run(out / robot, out / "truth" / robot).trajectory.ate_rmse_m;
  } catch (const std::exception& error) {
    spdlog::warn("no score of {}: {}", robot, error.what());
    return nullptr;
  }
}

ordered_json map_score(const fs::path& out, const std::string& first) {
  try {
    return to_json(evaluation::score_run(out / "team", out / "truth" / first));
  } catch (const std::exception& error) {
    spdlog::warn("no score of the map of all: {}", error.what());
    return nullptr;
  }
}

}  // namespace

void save_fleet_map(const pipeline::Snapshot& snapshot,
                    const team_map::MergedMap& merged,
                    const session::RobotProfile& profile,
                    const fs::path& out,
                    const exports::RunSummary& summary) {
  const fs::path team = out / "team";
  save_team_map(snapshot, profile, team, summary);
  save_provenance(merged, team / "provenance.csv");
  const fs::path path = out / "robot0" / kTrajectory;
  if (exists(path)) {
    files::write_text_file(team / kTrajectory, files::read_text_file(path));
  }
}

ordered_json fleet_report(const std::vector<std::string>& robots,
                          const FleetWatch& watch,
                          const fleet_member::TeamPicture& picture,
                          const fs::path& out) {
  const std::string first_map = fleet_member::map_name(robots.front(), 0);
  const auto first = truth_of(out, robots.front());
  auto members = ordered_json::array();
  const fleet::FleetState state = watch.state();
  for (const fleet::FleetRobot& member : state.robots) {
    const auto relative = picture.relative_pose(first_map, member);
    const auto truth = truth_of(out, member.name);
    // Where a later map began, no truth says.
    const bool is_scored = relative && first && truth && member.map_number == 0;
    members.push_back(
        {{"robot", member.name},
         {"joined", relative.has_value()},
         {"maps", member.maps.size()},
         {"relative_pose_error",
          is_scored ? relative_error(relative->T_own_peer, *first, *truth) : ordered_json()},
         {"ate_rmse_m", trajectory_error(out, member.name)}});
  }
  const team_map::JoinCounts& counts = picture.team().counts();
  return {{"robots", members},
          {"joins", counts.joins},
          {"joins_undone", counts.undone},
          {"objects", state.objects},
          {"seconds", last_stop_s(state)},
          {"bytes_per_s_per_robot", bytes_per_s_per_robot(state, watch.statistics().bytes)},
          {"map", map_score(out, robots.front())}};
}

}  // namespace echomap::apps
