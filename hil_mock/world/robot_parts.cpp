// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_parts.hpp"

#include <algorithm>

#include "hil_mock/world/floor_contact.hpp"
#include "hil_mock/world/ir_switches.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

NoiseStream noise_of_channel(std::uint32_t seed, int channel) {
  const auto first = static_cast<std::uint32_t>(NoisePurpose::kRange0);
  return {seed, static_cast<NoisePurpose>(first + static_cast<std::uint32_t>(channel))};
}

int channel_of(PinPart part) { return static_cast<int>(part) - static_cast<int>(PinPart::kRange0); }

}  // namespace

RobotParts::RobotParts(const FloorPlan& plan,
                       const RobotBody& body,
                       const PartParams& params,
                       std::uint32_t seed)
    : plan_(plan), body_(body), params_(params), heading_rad_(body.T_world_robot().heading_rad()) {
  for (const IrRangeParams& range : params.ranges) {
    ranges_.emplace_back(plan, range, noise_of_channel(seed, range.channel));
  }
  if (params.gyro) {
    gyro_.emplace(RateGyro(*params.gyro, NoiseStream(seed, NoisePurpose::kGyro)));
  }
  if (params.battery) {
    battery_.emplace(*params.battery, NoiseStream(seed, NoisePurpose::kBattery));
  }
  if (params.scalar) {
    scalar_.emplace(plan, *params.scalar, NoiseStream(seed, NoisePurpose::kScalarSensor));
  }
}

void RobotParts::step(double dt_s, const WheelDuty& duty) {
  for (IrRange& range : ranges_) {
    range.step(dt_s, body_.T_world_robot());
  }
  if (gyro_) {
    const double heading_rad = body_.T_world_robot().heading_rad();
    gyro_->step(dt_s, geometry::angle_between(heading_rad_, heading_rad) / dt_s);
    heading_rad_ = heading_rad;
  }
  if (battery_) {
    battery_->step(dt_s,
                   {duty.left, body_.left_wheel().speed_share()},
                   {duty.right, body_.right_wheel().speed_share()});
  }
  if (scalar_) {
    scalar_->step(dt_s, body_.T_world_robot());
  }
}

void RobotParts::drain_battery_to(double share) {
  if (battery_) {
    battery_->drain_to(share);
  }
}

bool RobotParts::is_active(PinPart part) const {
  switch (part) {
    case PinPart::kCliffLeft:
      return sees_cliff(CliffPlace::kLeft);
    case PinPart::kCliffFrontLeft:
      return sees_cliff(CliffPlace::kFrontLeft);
    case PinPart::kCliffFrontRight:
      return sees_cliff(CliffPlace::kFrontRight);
    case PinPart::kCliffRight:
      return sees_cliff(CliffPlace::kRight);
    case PinPart::kWheelDrop:
      return !body_.support().left || !body_.support().right;
    case PinPart::kVirtualWall:
      return params_.beam_detector &&
             beam_detected(plan_, body_.T_world_robot(), *params_.beam_detector);
    case PinPart::kWall:
      return params_.wall && wall_detected(plan_, body_.T_world_robot(), *params_.wall);
    default:
      return false;
  }
}

double RobotParts::millivolts(PinPart part) {
  if (part == PinPart::kBattery) {
    return battery_ ? battery_->pin_millivolts() : 0.0;
  }
  if (part == PinPart::kScalarLevel) {
    return scalar_ ? scalar_->millivolts() : 0.0;
  }
  const auto range = std::find_if(ranges_.begin(), ranges_.end(), [&](const IrRange& candidate) {
    return candidate.params().channel == channel_of(part);
  });
  return range == ranges_.end() ? 0.0 : range->millivolts();
}

/// Of a lifted robot every one looks into the depth.
bool RobotParts::sees_cliff(CliffPlace place) const {
  return std::any_of(params_.cliffs.begin(), params_.cliffs.end(), [&](const CliffParams& sensor) {
    return sensor.place == place &&
           (body_.is_lifted() || cliff_under(plan_, body_.T_world_robot(), sensor));
  });
}

}  // namespace echomap::world
