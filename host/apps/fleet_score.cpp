// SPDX-License-Identifier: MIT
#include "host/apps/fleet_score.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/fleet_course.hpp"
#include "host/apps/fleet_map_files.hpp"
#include "host/apps/member_report.hpp"
#include "host/apps/report.hpp"
#include "host/evaluation/floor_seen.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kTrajectory = "trajectory.tum";

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
    return evaluation::read_truth(truth_folder(out, robot));
  } catch (const files::FileError& error) {
    spdlog::warn("no truth of {}: {}", robot, error.what());
    return std::nullopt;
  }
}

/// Its own run against its own truth.
ordered_json trajectory_error(const fs::path& out, const std::string& robot) {
  try {
    return evaluation::score_run(out / robot, truth_folder(out, robot)).trajectory.ate_rmse_m;
  } catch (const std::exception& error) {
    spdlog::warn("no score of {}: {}", robot, error.what());
    return nullptr;
  }
}

ordered_json map_score(const fs::path& out, const std::string& first) {
  try {
    return to_json(evaluation::score_run(out / "team", truth_folder(out, first)));
  } catch (const std::exception& error) {
    spdlog::warn("no score of the map of all: {}", error.what());
    return nullptr;
  }
}

/// What it has written; of one that was killed there may be nothing.
MemberReport member_report(const fs::path& out, const std::string& robot) {
  try {
    return read_member_report(robot, out / robot);
  } catch (const files::FileError& error) {
    spdlog::warn("no report of {}: {}", robot, error.what());
    MemberReport nothing;
    nothing.robot = robot;
    return nothing;
  }
}

using Truths = std::map<std::string, std::optional<evaluation::Truth>>;

/// All maps of a fleet, by the truth. The floor is that in the first robot's reach.
std::vector<ScoredMap> scored_maps(const fleet::FleetState& state,
                                   const Truths& truths,
                                   const std::string& first) {
  std::vector<ScoredMap> scored;
  const auto first_truth = truths.find(first);
  if (first_truth == truths.end() || !first_truth->second ||
      first_truth->second->trajectory.empty()) {
    return scored;
  }
  std::vector<Eigen::Vector2d> floor_m;
  for (const fleet::FleetRobot& robot : state.robots) {
    const auto& truth = truths.at(robot.name);
    if (!truth || robot.traits.body_radius_m <= 0.0) {
      continue;
    }
    if (floor_m.empty()) {
      const auto& of_first = *first_truth->second;
      floor_m = evaluation::floor_in_reach_m(of_first.map.cells,
                                             of_first.trajectory.front().T_world_robot.position_m(),
                                             robot.traits.body_radius_m);
    }
    for (const fleet::FleetMap& map : robot.maps) {
      team_map::RobotRecord record = *map.record;
      record.robot = fleet_member::map_name(robot.name, map.number);
      if (auto one = score_map(record, truth->trajectory, floor_m)) {
        scored.push_back(*std::move(one));
      }
    }
  }
  return scored;
}

ordered_json figure_or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json to_json(const RelativePoseError& error) {
  return {{"position_m", error.position_m},
          {"heading_rad", error.heading_rad},
          {"own_errors_m", error.own_errors_m}};
}

ordered_json to_json(const FleetCourse& course) {
  return {{"joined_s", figure_or_null(course.joined_s)},
          {"wrong_joins", course.wrong_joins},
          {"wrong_joins_left", course.wrong_joins_left},
          {"floor_90_s", figure_or_null(course.floor_90_s)},
          {"floor_seen", course.floor_seen}};
}

}  // namespace

fs::path truth_folder(const fs::path& out, const std::string& robot) {
  const fs::path of_several = out / "truth" / robot;
  return exists(of_several) ? of_several : out / "truth";
}

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
  const fleet::FleetState state = watch.state();
  Truths truths;
  for (const fleet::FleetRobot& member : state.robots) {
    truths.emplace(member.name, truth_of(out, member.name));
  }
  const std::vector<ScoredMap> scored = scored_maps(state, truths, robots.front());
  const std::string first_map = latest_map(state, robots.front());
  auto members = ordered_json::array();
  std::vector<MemberReport> reports;
  for (const fleet::FleetRobot& member : state.robots) {
    const auto relative = picture.relative_pose(first_map, member);
    const ScoredMap* first = find_map(scored, first_map);
    const ScoredMap* own = find_map(scored, fleet_member::map_name(member.name, member.map_number));
    const bool is_scored = relative && first != nullptr && own != nullptr;
    reports.push_back(member_report(out, member.name));
    members.push_back({{"robot", member.name},
                       {"joined", relative.has_value()},
                       {"maps", member.maps.size()},
                       {"relative_pose_error",
                        is_scored ? to_json(relative_pose_error(relative->T_own_peer, *first, *own))
                                  : ordered_json()},
                       {"ate_rmse_m", trajectory_error(out, member.name)}});
    members.back().update(to_json(reports.back()));
  }
  const team_map::JoinCounts& counts = picture.team().counts();
  return {{"robots", members},
          {"joins", counts.joins},
          {"joins_undone", counts.undone},
          {"course", scored.empty() ? ordered_json() : to_json(score_course(scored, reports))},
          {"objects", state.objects},
          {"seconds", last_stop_s(state)},
          {"bytes_per_s_per_robot", bytes_per_s_per_robot(state, watch.statistics().bytes)},
          {"map", map_score(out, robots.front())}};
}

}  // namespace echomap::apps
