// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::localization {

/// Another robot, known which, as a sensor in the robot's centre has seen it.
struct PeerSighting {
  double stamp_s = 0.0;
  double range_m = 0.0;
  double bearing_rad = 0.0;
  double range_stddev_m = 0.1;
  double bearing_stddev_rad = 0.05;
};

}  // namespace echomap::localization
