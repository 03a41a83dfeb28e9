// SPDX-License-Identifier: MIT
#include "host/mapping/bearing_profile.hpp"

#include <limits>

namespace echomap::mapping {

std::size_t BearingProfile::index(double bearing_rad) {
  const double turned_rad = std::max(0.0, bearing_rad + std::numbers::pi);
  return std::min(static_cast<std::size_t>(turned_rad / kStepRad), kBearings - 1);
}

double BearingProfile::bearing_rad(std::size_t index) {
  return -std::numbers::pi + (static_cast<double>(index) + 0.5) * kStepRad;
}

double BearingProfile::max_m() const {
  return *std::max_element(distances_m_.begin(), distances_m_.end());
}

BearingProfile heard_within(const std::vector<sensors::Beam>& looks, double half_rad) {
  BearingProfile heard_m(-1.0);
  for (const sensors::Beam& look : looks) {
    const double range_m = look.range_m.value_or(std::numeric_limits<double>::infinity());
    BearingProfile::visit_about(look.bearing_rad, half_rad, [&](std::size_t i) {
      heard_m[i] = heard_m[i] < 0.0 ? range_m : std::min(heard_m[i], range_m);
    });
  }
  for (std::size_t i = 0; i < BearingProfile::kBearings; ++i) {
    heard_m[i] = std::max(0.0, heard_m[i]);
  }
  return heard_m;
}

}  // namespace echomap::mapping
