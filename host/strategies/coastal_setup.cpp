// SPDX-License-Identifier: MIT
#include "host/strategies/coastal_setup.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

#include "host/geometry/angle.hpp"
#include "protocol/limits.hpp"

namespace echomap::strategies {
namespace {

using exploration::Hand;
using session::RobotProfile;

/// The wall sensor looks so far off straight ahead, at least and at most.
constexpr double kMinAsideRad = geometry::radians(45.0);
constexpr double kMaxAsideRad = geometry::radians(135.0);

/// A visitor of the pins' fields that looks for one wired to a function.
struct FindPin {
  unsigned function;
  bool is_found = false;
  void operator()(std::string_view name, std::uint8_t pin) {
    is_found = is_found || (name != "command_id" &&
                            (pin & ~static_cast<unsigned>(protocol::kPinActiveHigh)) == function);
  }
};

bool is_wired(const RobotProfile& profile, unsigned function) {
  FindPin find{function};
  protocol::ConfigurePins::each(profile.configuration.pins, find);
  return find.is_found;
}

/// The infra-red sensor that looks to that side.
std::optional<std::size_t> sensor_at(const RobotProfile& profile, Hand hand) {
  for (std::size_t i = 0; i < profile.sensors.infrared.size(); ++i) {
    const double heading_rad = profile.sensors.infrared[i].T_robot_sensor.heading_rad();
    const double aside_rad = hand == Hand::kRight ? -heading_rad : heading_rad;
    if (aside_rad >= kMinAsideRad && aside_rad <= kMaxAsideRad) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string lack_for_coastal(const RobotProfile& profile, Hand hand) {
  if (!is_wired(profile, protocol::kPinWall)) {
    return "a wall sensor on a pin named 'wall'";
  }
  if (!sensor_at(profile, hand)) {
    return hand == Hand::kRight ? "its wall sensor on the right" : "its wall sensor on the left";
  }
  return "";
}

exploration::CoastalParams coastal_params(const RobotProfile& profile, Hand hand) {
  exploration::CoastalParams params;
  params.hand = hand;
  params.robot_radius_m = profile.body_radius_m;
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): value() throws
  params.sensor_index = sensor_at(profile, hand).value();
  params.T_robot_sensor = profile.sensors.infrared[params.sensor_index].T_robot_sensor;
  // The offset is what a whole drive gains at its ends, and a tick of a walk has none.
  params.correction.slope = profile.distance_correction.slope;
  return params;
}

exploration::CoastalParams as_told(exploration::CoastalParams params) {
  params.rule = exploration::TraversalRule::kAngleAboutStart;
  params.min_gap_m = 0.0;
  return params;
}

}  // namespace echomap::strategies
