// SPDX-License-Identifier: MIT
#include "host/exploration/traversal_watch.hpp"

#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

TraversalWatch::TraversalWatch(const TraversalParams& params) : params_(params) {
  geometry::ParameterValidator("traversal watch")
      .positive("reach_m", params.reach_m)
      .at_least("reach_per_m", params.reach_per_m, 0.0)
      .at_least("turn_slack_rad", params.turn_slack_rad, 0.0);
}

void TraversalWatch::add(const WallStep& step) {
  const Eigen::Vector2d& place_m = step.T_map_robot.position_m();
  const double bearing_rad = std::atan2(place_m.y(), place_m.x());
  if (!first_) {
    first_ = step;
    bearing_rad_ = bearing_rad;
  }
  covered_rad_ += geometry::angle_between(bearing_rad_, bearing_rad);
  bearing_rad_ = bearing_rad;
  if (!along_turned_rad_ && step.contact.wall_beside && !step.contact.bumped) {
    along_turned_rad_ = step.turned_rad;
  }
  if (state_ != Traversal::kUnderway || !along_turned_rad_) {
    return;
  }
  const double turned_rad = step.turned_rad - *along_turned_rad_;
  const double away_m = (place_m - first_->T_map_robot.position_m()).norm();
  if (std::abs(turned_rad) >= geometry::kFullTurnRad - params_.turn_slack_rad &&
      away_m <= params_.reach_m + params_.reach_per_m * step.travelled_m) {
    state_ = turned_rad > 0.0 ? Traversal::kRoundRoom : Traversal::kRoundIsland;
    round_m_ = step.travelled_m;
  }
}

}  // namespace echomap::exploration
