// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/sonar_surfaces.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

/// The bearing of a surface that answered from `range_m` (metres), at most `within_rad` off
/// `near_rad`: the mean of all bearings there, each as likely as the looks around are if something
/// stands there that is heard up to some unknown angle to either side. Silence, and echoes from
/// farther away, say that the surface was not heard; echoes from nearer say nothing, since they
/// would have come first. So what cuts a region short on one side does not pull its middle to the
/// other.
double likely_bearing_rad(const std::vector<sensors::Beam>& looks,
                          double near_rad,
                          double within_rad,
                          double range_m,
                          const SonarSurfaceParams& params);

/// The range (metres) that a look so far (radians) off the foot of the perpendicular hears of a
/// wall: that of the foot while it is in the beam, and beyond from where the beam's edge meets it.
double range_off_foot_m(double foot_m, double off_rad, const SonarSurfaceParams& params);

}  // namespace echomap::mapping
