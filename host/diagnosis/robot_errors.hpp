// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::diagnosis {

/// By what a robot differs from its profile. As made, it is the robot that the profile describes.
struct RobotErrors {
  /// What a wheel rolls in truth, as a multiple of its travel by the profile; negative where it
  /// rolls the other way.
  double left_scale = 1.0;
  double right_scale = 1.0;
  double track_scale = 1.0;
  /// The true pan is `pan_scale * pan + pan_offset_rad`, counter-clockwise; -1 where it is
  /// reversed.
  double pan_scale = 1.0;
  double pan_offset_rad = 0.0;
  double range_scale = 1.0;
};

}  // namespace echomap::diagnosis
