// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "host/datasets/mrclam_team.hpp"
#include "host/localization/joint_localizer.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::pipeline {

/// Settings of a TeamReplay. Those of sightings are of the cameras of UTIAS MRCLAM, measured on its
/// set 7; what errs slowly is in `localizer`.
struct TeamReplayParams {
  localization::JointLocalizerParams localizer{};
  /// Of the random error of a range: the root of the sum of the squares of both.
  double range_stddev_m = 0.02;
  double range_stddev_share = 0.02;
  /// The same of a bearing: in itself, and what neither camera nor barcode are in the middle of
  /// their robots.
  double bearing_stddev_rad = 0.01;
  double offset_stddev_m = 0.03;
  /// Of where a robot starts.
  double start_stddev_m = 0.01;
  double start_stddev_rad = 0.01;
  /// A start that is given for longer before the robot moves is not its own.
  double max_start_age_s = 0.5;
  /// Whether robots see each other.
  bool with_peers = true;
  /// Robots whose sightings of landmarks are left out.
  std::set<std::int64_t> blind;
};

/// Where a robot believes to be.
struct StampedBelief {
  time::RobotTime stamp;
  localization::PoseGaussian belief;
};

/// What came of the sightings of one robot, by landmarks and peers together.
struct SightingCounts {
  std::size_t landmarks = 0;  ///< Applied sightings of landmarks.
  std::size_t peers = 0;      ///< Applied sightings of other robots.
  std::size_t gated = 0;      ///< Too far off to be true.
  std::size_t unknown = 0;    ///< Of what is neither a landmark nor a robot that has started.
};

/// Feeds the logs of a team to a JointLocalizer. A robot takes part from its first odometry on for
/// which the log gives a pose.
class TeamReplay {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit TeamReplay(std::map<std::int64_t, Eigen::Vector2d> landmarks_m,
                      const TeamReplayParams& params = {});

  /// Records are to come in the order of their stamps.
  void play(const datasets::TeamRecord& record);

  /// Beliefs of a robot at its odometry's stamps; empty for one that has not started.
  const std::vector<StampedBelief>& track(std::int64_t robot) const;
  SightingCounts counts(std::int64_t robot) const;
  /// How often a robot has been taken for lost.
  std::size_t times_lost(std::int64_t robot) const;

 private:
  struct Member {
    std::optional<std::size_t> index;  ///< In the localizer, once started.
    std::optional<datasets::TeamRecord> given;
    std::vector<StampedBelief> track;
    SightingCounts counts;
  };

  void move(Member& member, double stamp_s, const geometry::Pose2& T_last_now);
  void start(Member& member, double stamp_s);
  void see(Member& member,
           std::int64_t robot,
           double stamp_s,
           const datasets::LandmarkSighting& seen);

  std::map<std::int64_t, Eigen::Vector2d> landmarks_m_;
  TeamReplayParams params_;
  localization::JointLocalizer localizer_;
  std::map<std::int64_t, Member> members_;
};

}  // namespace echomap::pipeline
