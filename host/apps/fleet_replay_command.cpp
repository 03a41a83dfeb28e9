// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/progress_bar.hpp"
#include "host/console/shell_line.hpp"
#include "host/datasets/mrclam_team.hpp"
#include "host/evaluation/team_comparison.hpp"
#include "host/exports/trajectory_tum.hpp"

namespace echomap::apps {
namespace {

using evaluation::BeliefError;
using evaluation::RobotComparison;
using evaluation::TeamComparison;
using evaluation::TeamScore;
using nlohmann::ordered_json;

/// Records between two looks at the clock and at whether the user has had enough.
constexpr std::size_t kRecordsAtOnce = 5000;

/// Null for a figure that needs a truth where none is.
ordered_json json_of(const std::optional<double>& figure) {
  return figure ? ordered_json(*figure) : ordered_json(nullptr);
}

std::optional<double> figure_of(const BeliefError& error, double BeliefError::*figure) {
  return error.poses > 0 ? std::optional(error.*figure) : std::nullopt;
}

ordered_json json_of(const RobotComparison& robot, const pipeline::TeamReplay& joint) {
  const auto counts = joint.counts(robot.robot);
  return {
      {"robot", robot.robot},
      {"trajectory", fmt::format("trajectory_{}.tum", robot.robot)},
      {"poses", joint.track(robot.robot).size()},
      {"rmse_odometry_m", json_of(figure_of(robot.odometry, &BeliefError::rmse_m))},
      {"rmse_alone_m", json_of(figure_of(robot.alone, &BeliefError::rmse_m))},
      {"rmse_joint_m", json_of(figure_of(robot.joint, &BeliefError::rmse_m))},
      {"gain_percent", json_of(robot.gain_percent())},
      {"heading_rmse_joint_rad", json_of(figure_of(robot.joint, &BeliefError::heading_rmse_rad))},
      {"expected_rmse_alone_m", json_of(figure_of(robot.alone, &BeliefError::expected_rmse_m))},
      {"expected_rmse_joint_m", json_of(figure_of(robot.joint, &BeliefError::expected_rmse_m))},
      {"nees_alone", json_of(figure_of(robot.alone, &BeliefError::nees))},
      {"nees_joint", json_of(figure_of(robot.joint, &BeliefError::nees))},
      {"within_95_alone", json_of(figure_of(robot.alone, &BeliefError::within_95))},
      {"within_95_joint", json_of(figure_of(robot.joint, &BeliefError::within_95))},
      {"landmark_sightings", counts.landmarks},
      {"peer_sightings", counts.peers},
      {"gated_sightings", counts.gated},
      {"unknown_sightings", counts.unknown},
      {"times_lost", joint.times_lost(robot.robot)}};
}

ordered_json report_of(const FleetReplayOptions& options,
                       const RunEnding& ending,
                       const TeamScore& score,
                       const pipeline::TeamReplay& joint) {
  ordered_json json = to_json(ending);
  json.update({{"log", options.folder.string()},
               {"blind", options.blind},
               {"rmse_odometry_m", json_of(score.odometry_rmse_m)},
               {"rmse_alone_m", json_of(score.alone_rmse_m)},
               {"rmse_joint_m", json_of(score.joint_rmse_m)},
               {"gain_percent", json_of(score.gain_percent)},
               {"min_gain_percent", json_of(score.min_gain_percent)},
               {"robots", ordered_json::array()}});
  for (const RobotComparison& robot : score.robots) {
    json["robots"].push_back(json_of(robot, joint));
  }
  return json;
}

/// Plays the logs until they end or the user has had enough; answers whether they ended.
bool play(const datasets::TeamLog& team, TeamComparison& comparison, bool is_headless) {
  console::ProgressBar progress(stderr, !is_headless);
  for (std::size_t i = 0; i < team.records.size(); ++i) {
    if (i % kRecordsAtOnce == 0) {
      if (console::interrupted()) {
        progress.clear();
        return false;
      }
      progress.show(static_cast<double>(i) / static_cast<double>(team.records.size()),
                    fmt::format("{} robots", team.robots.size()));
    }
    comparison.play(team.records[i]);
  }
  progress.clear();
  return true;
}

std::string gain_in_words(double gain_percent) {
  return fmt::format(
      "{:.0f} % {}", std::abs(gain_percent), gain_percent < 0.0 ? "worse" : "better");
}

void print(const TeamScore& score, const pipeline::TeamReplay& joint) {
  for (const RobotComparison& robot : score.robots) {
    const auto counts = joint.counts(robot.robot);
    std::string line = fmt::format("  robot {}: {} sightings of landmarks, {} of robots, {} gated",
                                   robot.robot,
                                   counts.landmarks,
                                   counts.peers,
                                   counts.gated);
    if (const auto gain = robot.gain_percent()) {
      line += fmt::format("; RMSE {:.3f} m by odometry, {:.3f} m alone, {:.3f} m jointly: {}",
                          robot.odometry.rmse_m,
                          robot.alone.rmse_m,
                          robot.joint.rmse_m,
                          gain_in_words(*gain));
    }
    console::print(line);
  }
}

void warn_of(const datasets::TeamLog& team, const pipeline::TeamReplay& joint) {
  for (const std::string& note : team.notes) {
    spdlog::warn("{}", note);
  }
  for (const std::int64_t robot : team.robots) {
    if (joint.track(robot).empty()) {
      spdlog::warn("robot {} takes no part: no pose is given where its odometry begins", robot);
    } else if (const std::size_t times = joint.times_lost(robot); times > 0) {
      spdlog::warn("robot {} was taken for lost {} times: its sightings contradicted its pose",
                   robot,
                   times);
    }
  }
}

void check_blind(const std::vector<std::int64_t>& blind, const datasets::TeamLog& team) {
  for (const std::int64_t robot : blind) {
    if (!std::ranges::count(team.robots, robot)) {
      throw CommandError(ExitCode::kUsage,
                         fmt::format("--blind {0}: the logs have no robot {0}, only {1}\n"
                                     "  next: echomap fleet replay --help",
                                     robot,
                                     fmt::join(team.robots, ", ")));
    }
  }
}

RunEnding ending_of_team(bool has_ended,
                         const TeamScore& score,
                         const FleetReplayOptions& options) {
  console::CommandWords again{"echomap", "fleet", "replay", options.folder.string()};
  if (!has_ended) {
    return {"interrupted", ExitCode::kInterrupted, "interrupted", console::shell_line(again)};
  }
  std::string why = fmt::format("{} robots were localized jointly", score.robots.size());
  if (score.gain_percent) {
    why += fmt::format(": RMSE {:.3f} m, {} than alone; the robot that gains least is {}",
                       *score.joint_rmse_m,
                       gain_in_words(*score.gain_percent),
                       gain_in_words(*score.min_gain_percent));
  }
  if (options.blind.empty()) {
    again.insert(again.end(), {"--blind", std::to_string(score.robots.back().robot)});
  }
  return {"finished", ExitCode::kOk, why, console::shell_line(again)};
}

void write_trajectories(const TeamScore& score,
                        const pipeline::TeamReplay& joint,
                        const std::filesystem::path& out) {
  for (const RobotComparison& robot : score.robots) {
    std::vector<pipeline::StampedPose> trajectory;
    for (const auto& [stamp, belief] : joint.track(robot.robot)) {
      trajectory.push_back({stamp, belief.T_map_robot});
    }
    exports::write_trajectory_tum(out / fmt::format("trajectory_{}.tum", robot.robot), trajectory);
  }
}

}  // namespace

ExitCode run_fleet_replay(const FleetReplayOptions& options) {
  const auto out = run_folder(options.out);
  prepare_outputs(out, options.json, options.force);
  const datasets::TeamLog team = datasets::read_mrclam_team(options.folder);
  check_blind(options.blind, team);
  pipeline::TeamReplayParams params;
  params.blind.insert(options.blind.begin(), options.blind.end());
  TeamComparison comparison(team.landmarks_m, params);
  const bool has_ended = play(team, comparison, options.headless);
  const pipeline::TeamReplay& joint = comparison.joint();
  warn_of(team, joint);
  const TeamScore score = comparison.score(team.robots);
  if (has_ended && score.robots.size() < 2) {
    throw CommandError(ExitCode::kRuntimeError,
                       options.folder.string() +
                           ": fewer than two robots have a known start\n  next: put "
                           "RobotN_Groundtruth.dat beside their odometry");
  }
  write_trajectories(score, joint, out);
  const RunEnding ending = ending_of_team(has_ended, score, options);
  const ordered_json report = report_of(options, ending, score, joint);
  write_report(out / "summary.json", report);
  write_report(options.json, report);
  print(score, joint);
  console::print("trajectories: " + (out / "trajectory_ROBOT.tum").string());
  print_ending(ending, "the trajectories up to there");
  return ending.code;
}

}  // namespace echomap::apps
