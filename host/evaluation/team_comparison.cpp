// SPDX-License-Identifier: MIT
#include "host/evaluation/team_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "host/geometry/square.hpp"

namespace echomap::evaluation {

namespace {

using pipeline::TeamReplayParams;

TeamReplayParams without_peers(TeamReplayParams params) {
  params.with_peers = false;
  return params;
}

double gain(double alone_m, double joint_m) { return 100.0 * (1.0 - joint_m / alone_m); }

/// Root of the mean of the robots' mean squares.
double pooled_rmse_m(const std::vector<RobotComparison>& robots,
                     BeliefError RobotComparison::*which) {
  double squares_m2 = 0.0;
  for (const RobotComparison& robot : robots) {
    squares_m2 += geometry::square((robot.*which).rmse_m);
  }
  return std::sqrt(squares_m2 / static_cast<double>(robots.size()));
}

}  // namespace

std::optional<double> RobotComparison::gain_percent() const {
  return joint.poses > 0 && alone.rmse_m > 0.0 ? std::optional(gain(alone.rmse_m, joint.rmse_m))
                                               : std::nullopt;
}

TeamComparison::TeamComparison(const std::map<std::int64_t, Eigen::Vector2d>& landmarks_m,
                               const TeamReplayParams& params)
    : odometry_({}, without_peers(params)),
      alone_(landmarks_m, without_peers(params)),
      joint_(landmarks_m, params) {}

void TeamComparison::play(const datasets::TeamRecord& record) {
  if (const auto* given = std::get_if<datasets::GivenPose>(&record.record)) {
    truths_[record.robot].push_back({time::robot_time(record.stamp_s), given->T_map_robot});
  }
  odometry_.play(record);
  alone_.play(record);
  joint_.play(record);
}

TeamScore TeamComparison::score(const std::vector<std::int64_t>& robots) const {
  TeamScore score;
  bool has_truth = true;
  for (const std::int64_t robot : robots) {
    if (joint_.track(robot).empty()) {
      continue;
    }
    const auto truth = truths_.find(robot);
    const std::vector<TruePose> none;
    const auto& poses = truth == truths_.end() ? none : truth->second;
    score.robots.push_back({robot,
                            score_beliefs(odometry_.track(robot), poses),
                            score_beliefs(alone_.track(robot), poses),
                            score_beliefs(joint_.track(robot), poses)});
    const auto gained = score.robots.back().gain_percent();
    has_truth = has_truth && gained.has_value();
    if (gained) {
      score.min_gain_percent = std::min(*gained, score.min_gain_percent.value_or(*gained));
    }
  }
  if (has_truth && !score.robots.empty()) {
    score.odometry_rmse_m = pooled_rmse_m(score.robots, &RobotComparison::odometry);
    score.alone_rmse_m = pooled_rmse_m(score.robots, &RobotComparison::alone);
    score.joint_rmse_m = pooled_rmse_m(score.robots, &RobotComparison::joint);
    score.gain_percent = gain(*score.alone_rmse_m, *score.joint_rmse_m);
  }
  return score;
}

}  // namespace echomap::evaluation
