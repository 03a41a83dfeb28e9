// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/angle.hpp"
#include "host/mapping/bearing_profile.hpp"

namespace echomap::mapping {

inline double at(const BearingProfile& profile, double bearing_deg) {
  return profile[BearingProfile::index(geometry::radians(bearing_deg))];
}

}  // namespace echomap::mapping
