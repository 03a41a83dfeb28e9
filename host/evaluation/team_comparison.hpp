// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "host/datasets/mrclam_team.hpp"
#include "host/evaluation/belief_error.hpp"
#include "host/evaluation/trajectory_error.hpp"
#include "host/pipeline/team_replay.hpp"

namespace echomap::evaluation {

/// How one robot of a team is localized with less and more to go by.
struct RobotComparison {
  std::int64_t robot = 0;
  BeliefError odometry;  ///< By its odometry from its start on.
  BeliefError alone;     ///< With its own sightings of landmarks.
  BeliefError joint;     ///< With all sightings of all robots.
  /// By how much its RMSE is lower than alone, percent; empty where the truth is not known.
  std::optional<double> gain_percent() const;
};

/// The robots of a team, and the RMSE of all their poses, each robot counting the same.
struct TeamScore {
  std::vector<RobotComparison> robots;
  std::optional<double> odometry_rmse_m;
  std::optional<double> alone_rmse_m;
  std::optional<double> joint_rmse_m;
  std::optional<double> gain_percent;
  /// That of the robot that gains least.
  std::optional<double> min_gain_percent;
};

/// Plays the logs of a team three times at once, with the same settings: by odometry, each robot
/// alone, and jointly.
class TeamComparison {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  TeamComparison(const std::map<std::int64_t, Eigen::Vector2d>& landmarks_m,
                 const pipeline::TeamReplayParams& params = {});

  /// Records are to come in the order of their stamps.
  void play(const datasets::TeamRecord& record);

  const pipeline::TeamReplay& joint() const { return joint_; }
  /// Of these robots those that have started.
  TeamScore score(const std::vector<std::int64_t>& robots) const;

 private:
  pipeline::TeamReplay odometry_;
  pipeline::TeamReplay alone_;
  pipeline::TeamReplay joint_;
  std::map<std::int64_t, std::vector<TruePose>> truths_;
};

}  // namespace echomap::evaluation
