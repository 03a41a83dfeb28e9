// SPDX-License-Identifier: MIT
#include "host/evaluation/team_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

std::optional<PooledComparison> pooled(const std::vector<RobotComparison>& robots) {
  if (robots.empty()) {
    return std::nullopt;
  }
  PooledComparison together{pooled_rmse_m(robots, &RobotComparison::odometry),
                            pooled_rmse_m(robots, &RobotComparison::alone),
                            pooled_rmse_m(robots, &RobotComparison::joint)};
  together.gain_percent = gain(together.alone_rmse_m, together.joint_rmse_m);
  together.min_gain_percent = std::numeric_limits<double>::infinity();
  for (const RobotComparison& robot : robots) {
    const auto gained = robot.gain_percent();
    if (!gained) {
      return std::nullopt;
    }
    together.min_gain_percent = std::min(together.min_gain_percent, *gained);
  }
  return together;
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
  const std::vector<TruePose> unknown;
  TeamScore score;
  for (const std::int64_t robot : robots) {
    if (joint_.track(robot).empty()) {
      continue;
    }
    const auto known = truths_.find(robot);
    const auto& truth = known == truths_.end() ? unknown : known->second;
    score.robots.push_back({robot,
                            score_beliefs(odometry_.track(robot), truth),
                            score_beliefs(alone_.track(robot), truth),
                            score_beliefs(joint_.track(robot), truth)});
  }
  score.pooled = pooled(score.robots);
  return score;
}

}  // namespace echomap::evaluation
