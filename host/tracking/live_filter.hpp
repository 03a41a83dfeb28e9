// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/geometry/pose2.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/follower.hpp"

namespace echomap::tracking {

/// What follows a robot while it drives, as `echomap localize --filter` names it.
class LiveFilter : public session::Follower {
 public:
  /// At the end of a stop: the robot was found not to be where it was thought to be, or was lifted,
  /// since the last stop.
  virtual bool has_lost_it() = 0;
  /// How well a scan from a goal, seen from the robot, would tell apart where it may be: 0 where
  /// all goals do the same.
  virtual double telling(const geometry::Pose2& T_robot_goal) const = 0;
  /// Where the robot most likely is; empty where nothing says so.
  virtual std::optional<localization::PoseGaussian> estimate() const = 0;
  /// Places where the robot may be; null of a filter that has only one.
  virtual const localization::PoseBelief* hypotheses() const { return nullptr; }
  /// Poses where the robot may be, `count` at most; none where the filter has only one.
  virtual std::vector<geometry::Pose2> sampled_poses(std::size_t /*count*/) const { return {}; }
  /// Where the robot is, for people.
  virtual std::string line() const = 0;
  /// The same as the entries of a report.
  virtual nlohmann::ordered_json report() const = 0;
  virtual const std::vector<pipeline::StampedPose>& trajectory() const = 0;
};

}  // namespace echomap::tracking
