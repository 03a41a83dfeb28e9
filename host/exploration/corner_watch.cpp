// SPDX-License-Identifier: MIT
#include "host/exploration/corner_watch.hpp"

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

using mapping::CornerKind;

CornerWatch::CornerWatch(const CornerWatchParams& params) : params_(params) {
  geometry::ParameterValidator("corner watch")
      .positive("reflex_turn_rad", params.reflex_turn_rad)
      .positive("same_corner_m", params.same_corner_m);
}

void CornerWatch::add(const WallStep& step) {
  if (step.contact.bumped && step.contact.wall_ahead) {
    mark(CornerKind::kNonReflex, step);
  }
  if (step.contact.wall_beside) {
    lost_turned_rad_.reset();
    return;
  }
  if (!lost_turned_rad_) {
    lost_turned_rad_ = step.turned_rad;
    turn_is_marked_ = false;
  }
  if (!turn_is_marked_ && *lost_turned_rad_ - step.turned_rad > params_.reflex_turn_rad) {
    turn_is_marked_ = true;
    mark(CornerKind::kReflex, step);
  }
}

void CornerWatch::mark(CornerKind kind, const WallStep& step) {
  const bool is_new = marks_.empty() || marks_.back().kind != kind ||
                      step.travelled_m - marks_.back().travelled_m > params_.same_corner_m;
  if (is_new) {
    marks_.push_back({kind, step.T_map_robot.position_m(), step.travelled_m});
  }
}

}  // namespace echomap::exploration
