// SPDX-License-Identifier: MIT
#include "host/tracking/camera_fix.hpp"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace echomap::tracking {
namespace {

/// Not a number where it is none; `otherwise` where it is missing.
double number_in(const nlohmann::json& json, const char* key, double otherwise) {
  const auto found = json.find(key);
  if (found == json.end()) {
    return otherwise;
  }
  return found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<CameraFix> parse_camera_fix(std::string_view line) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  CameraFix fix;
  const double x_m = number_in(json, "x_m", kMissing);
  const double y_m = number_in(json, "y_m", kMissing);
  const double heading_rad = number_in(json, "heading_rad", kMissing);
  fix.stamp_s = number_in(json, "stamp_s", kMissing);
  fix.sent_s = number_in(json, "sent_s", fix.stamp_s);
  fix.stddev_m = number_in(json, "std_m", fix.stddev_m);
  fix.stddev_rad = number_in(json, "std_rad", fix.stddev_rad);
  for (const double number : {x_m, y_m, heading_rad, fix.stamp_s, fix.sent_s}) {
    constexpr double kLargest = 1e12;
    if (!(std::abs(number) < kLargest)) {
      return std::nullopt;
    }
  }
  const bool makes_sense = fix.sent_s >= fix.stamp_s && fix.stddev_m > 0.0 &&
                           fix.stddev_rad > 0.0 && std::isfinite(fix.stddev_m) &&
                           std::isfinite(fix.stddev_rad);
  if (!makes_sense) {
    return std::nullopt;
  }
  fix.T_camera_robot = {x_m, y_m, heading_rad};
  return fix;
}

}  // namespace echomap::tracking
