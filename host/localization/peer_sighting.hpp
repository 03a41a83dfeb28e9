// SPDX-License-Identifier: MIT
#pragma once

#include "host/localization/pose_gaussian.hpp"
#include "host/localization/pose_measurement.hpp"

namespace echomap::localization {

/// Another robot, known which, as a sensor in the robot's centre has seen it.
struct PeerSighting {
  double stamp_s = 0.0;
  double range_m = 0.0;
  double bearing_rad = 0.0;
  double range_stddev_m = 0.1;
  double bearing_stddev_rad = 0.05;
};

/// The robots' beliefs have something in common from the second sighting on, and it is not known
/// how much: what one tells the other counts half (Julier and Uhlmann 1997 bound it so).
inline constexpr double kTold = 2.0;

/// What the sighting says to the robot that looks: a landmark that is as unsure as the other robot.
/// Both beliefs are those of the sighting's instant.
LandmarkObservation peer_as_landmark(const PeerSighting& sighting,
                                     const PoseGaussian& observer,
                                     const PoseGaussian& peer);

/// What the sighting says to the robot that is seen: where it is, and nothing of its heading.
PoseFix peer_as_fix(const PeerSighting& sighting,
                    const PoseGaussian& observer,
                    const PoseGaussian& peer);

}  // namespace echomap::localization
