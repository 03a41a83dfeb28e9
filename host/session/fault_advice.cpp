// SPDX-License-Identifier: MIT
#include "host/session/fault_advice.hpp"

#include <cmath>

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "protocol/command_messages.hpp"

namespace echomap::session {
namespace {

using diagnosis::Fault;
using diagnosis::FaultKind;

std::string set(const std::string& key, const std::string& value, const char* table) {
  return fmt::format("set {} = {} in [{}] of the profile", key, value, table);
}

/// "8 % farther than" or "8 % less far than".
std::string farther(double scale) {
  return fmt::format(
      "{:.0f} % {} than", 100.0 * std::abs(scale - 1.0), scale > 1.0 ? "farther" : "less far");
}

/// The inversions of motor and encoder of a wheel, as they are not now.
std::string inverted(const RobotProfile& profile,
                     const char* wheel,
                     std::uint8_t motor_bit,
                     std::uint8_t encoder_bit) {
  const auto is_inverted = [&](std::uint8_t bit) {
    return (profile.configuration.drive.inversions & bit) != 0;
  };
  return fmt::format(
      "set invert_{0}_motor = {1} and invert_{0}_encoder = {2} in [drive] of the profile",
      wheel,
      !is_inverted(motor_bit),
      !is_inverted(encoder_bit));
}

std::string inverted_left(const RobotProfile& profile) {
  return inverted(profile, "left", protocol::kInvertLeftMotor, protocol::kInvertLeftEncoder);
}

std::string inverted_right(const RobotProfile& profile) {
  return inverted(profile, "right", protocol::kInvertRightMotor, protocol::kInvertRightEncoder);
}

FaultAdvice advice_of_pan(const Fault& fault, const RobotProfile& profile) {
  const protocol::ConfigurePan& pan = profile.configuration.pan;
  const bool is_servo = pan.kind == static_cast<std::uint8_t>(protocol::PanKind::kServo);
  if (fault.kind == FaultKind::kPanReversed) {
    const std::string key =
        is_servo ? set("us_per_90deg", std::to_string(-pan.us_per_90deg), "pan")
                 : set("half_steps_per_turn", std::to_string(-pan.steps_per_turn), "pan");
    return {
        "the pan turns the other way than the profile says, or left and right wheel are "
        "exchanged",
        "if the sonar turns right when it should turn left, " + key +
            "; if the robot does, exchange the motors and the encoders of its two wheels"};
  }
  const double off_deg = geometry::degrees(fault.value);
  const auto centre_us =
      static_cast<int>(std::lround(pan.centre_us - off_deg / 90.0 * pan.us_per_90deg));
  return {fmt::format("the sonar looks {:.0f} degrees to the {} when the profile has it look "
                      "straight ahead",
                      std::abs(off_deg),
                      off_deg > 0.0 ? "left" : "right"),
          is_servo ? set("centre_us", std::to_string(centre_us), "pan")
                   : "point it straight ahead before the board starts"};
}

/// Of a wheel that its commands or its counts contradict.
FaultAdvice advice_of_wiring(const std::string& wheel, bool stands) {
  return stands ? FaultAdvice{fmt::format("the {} wheel does not turn, or its encoder does not "
                                          "count",
                                          wheel),
                              fmt::format("free the wheel, and check the wires of the {} motor and "
                                          "encoder (docs/guides/wiring.md)",
                                          wheel)}
                : FaultAdvice{fmt::format("the {} wheel counts backwards when it is driven "
                                          "forwards",
                                          wheel),
                              fmt::format("if it turns backwards, change invert_{0}_motor, else "
                                          "invert_{0}_encoder in [drive] of the profile",
                                          wheel)};
}

/// Of wheels that their commands contradict.
FaultAdvice advice_of_command(FaultKind kind) {
  switch (kind) {
    case FaultKind::kLeftAgainst:
      return advice_of_wiring("left", false);
    case FaultKind::kRightAgainst:
      return advice_of_wiring("right", false);
    case FaultKind::kLeftStands:
      return advice_of_wiring("left", true);
    case FaultKind::kRightStands:
      return advice_of_wiring("right", true);
    default:
      return {
          "both wheels count against their commands: the motors or the encoders are "
          "exchanged, or both are reversed",
          "turn the left wheel by hand: if the right one counts, exchange the plugs of the "
          "encoders, else those of the motors; if that does not mend it, change "
          "invert_left_motor and invert_right_motor in [drive] of the profile"};
  }
}

FaultAdvice advice_of_wheel(const char* wheel, double scale, double now) {
  return {fmt::format("the {} wheel rolls {} the profile says", wheel, farther(scale)),
          set(fmt::format("{}_wheel_scale", wheel), fmt::format("{:.3f}", scale * now), "drive")};
}

FaultAdvice advice_of_counts(const char* wheel, double counts, double now) {
  return {fmt::format("the {} encoder gives {:.2f} times the counts of the profile", wheel, counts),
          set(fmt::format("{}_wheel_scale", wheel), fmt::format("{:.3f}", now / counts), "drive")};
}

FaultAdvice advice_of_dirt(const char* wheel, double lost_share) {
  return {fmt::format("the {} encoder loses {:.1f} % of its counts: edges come too fast after each "
                      "other, or are missed",
                      wheel,
                      100.0 * lost_share),
          fmt::format("clean the {0} encoder's disc and sensors, set their distance, and check the "
                      "wires and the supply of the {0} encoder (docs/guides/wiring.md)",
                      wheel)};
}

}  // namespace

FaultAdvice advice_of(const Fault& fault, const RobotProfile& profile) {
  const sensors::RobotGeometry& robot = profile.geometry;
  switch (fault.kind) {
    case FaultKind::kNone:
      break;
    case FaultKind::kLeftWheelSize:
      return advice_of_wheel("left", fault.value, robot.left_wheel_scale);
    case FaultKind::kRightWheelSize:
      return advice_of_wheel("right", fault.value, robot.right_wheel_scale);
    case FaultKind::kWheelSize:
      return {fmt::format("both wheels roll {} the profile says", farther(fault.value)),
              set("wheel_diameter_m",
                  fmt::format("{:.4f}", fault.value * robot.wheel_diameter_m),
                  "drive")};
    case FaultKind::kLeftCounts:
      return advice_of_counts("left", fault.value, robot.left_wheel_scale);
    case FaultKind::kRightCounts:
      return advice_of_counts("right", fault.value, robot.right_wheel_scale);
    case FaultKind::kCounts:
      return {fmt::format("the encoders give {:.2f} times the counts of the profile", fault.value),
              set("counts_per_turn",
                  fmt::format("{:.0f}", fault.value * robot.counts_per_turn),
                  "drive")};
    case FaultKind::kLeftReversed:
      return {"the left wheel goes backwards when it should go forwards", inverted_left(profile)};
    case FaultKind::kRightReversed:
      return {"the right wheel goes backwards when it should go forwards", inverted_right(profile)};
    case FaultKind::kBothReversed:
      return {"both wheels go backwards when they should go forwards",
              inverted_left(profile) + ", and " + inverted_right(profile)};
    case FaultKind::kNotMoving:
      return {"the wheels turn and the robot stays where it is",
              "free it, put it on the floor and see whether its wheels grip"};
    case FaultKind::kPanReversed:
    case FaultKind::kPanOffset:
      return advice_of_pan(fault, profile);
    case FaultKind::kRangeScale:
      return {
          fmt::format("the sonar's ranges are {:.0f} % too {}",
                      100.0 * std::abs(1.0 / fault.value - 1.0),
                      fault.value < 1.0 ? "long" : "short"),
          set("range_scale", fmt::format("{:.3f}", fault.value * profile.range_scale), "sonar")};
    case FaultKind::kLeftAgainst:
    case FaultKind::kRightAgainst:
    case FaultKind::kBothAgainst:
    case FaultKind::kLeftStands:
    case FaultKind::kRightStands:
      return advice_of_command(fault.kind);
    case FaultKind::kLeftDirty:
      return advice_of_dirt("left", fault.value);
    case FaultKind::kRightDirty:
      return advice_of_dirt("right", fault.value);
  }
  return {};
}

}  // namespace echomap::session
