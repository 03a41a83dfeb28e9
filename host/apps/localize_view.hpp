// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/apps/explore_progress.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/session/robot_context.hpp"
#include "host/tracking/live_filter.hpp"

namespace echomap::apps {

/// A place that particles agree on.
struct AgreedPose {
  geometry::Pose2 T_map_robot;
  double position_95_m = 0.0;  ///< 95 % are within so much, in the direction they spread most.
};

/// The mean of some poses; empty where there are less than two, or where they spread over more than
/// a robot's surroundings.
std::optional<AgreedPose> agreed_pose(const std::vector<geometry::Pose2>& poses);

/// Shows the localization of a robot in a map: the particles, and the robot where they agree.
class LocalizeView final : public ProgressSource {
 public:
  /// All of them outlive this.
  LocalizeView(const session::RobotContext& robot,
               const tracking::LiveFilter& filter,
               const mapping::RasterMap& map)
      : robot_(robot), filter_(filter), map_(map) {}

  /// None: a line for each stop is printed anyway.
  std::string line() override { return ""; }
  terminal_view::RunView view() override;
  double elapsed_s() const override { return now_s(robot_.session()); }

 private:
  const session::RobotContext& robot_;
  const tracking::LiveFilter& filter_;
  const mapping::RasterMap& map_;
};

}  // namespace echomap::apps
