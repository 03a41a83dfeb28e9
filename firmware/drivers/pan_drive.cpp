// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_drive.hpp"

#include "firmware/hal/servo.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace drivers {
namespace {

/// A servo does not turn round.
constexpr int32_t kHalfTurnCdeg = 18000;

bool is_stepper(const protocol::ConfigurePan& settings) {
  return settings.kind == static_cast<uint8_t>(protocol::PanKind::kStepper);
}

}  // namespace

bool PanDrive::accepts(const protocol::ConfigurePan& settings) {
  const int32_t limit_cdeg = is_stepper(settings) ? protocol::kMaxPanCdeg : kHalfTurnCdeg;
  if (settings.min_cdeg > settings.max_cdeg || settings.min_cdeg < -limit_cdeg ||
      settings.max_cdeg > limit_cdeg || settings.deg_per_s == 0) {
    return false;
  }
  if (is_stepper(settings)) {
    return PanStepper::accepts(settings);
  }
  return settings.kind == static_cast<uint8_t>(protocol::PanKind::kServo) &&
         PanServo::accepts(settings);
}

void PanDrive::configure(const protocol::ConfigurePan& settings) {
  settings_ = settings;
  servo_.lose_track();
}

bool PanDrive::reaches(int32_t pan_cdeg) const {
  return pan_cdeg >= settings_.min_cdeg && pan_cdeg <= settings_.max_cdeg &&
         (!is_stepper(settings_) || pins_.has_stepper());
}

void PanDrive::turn_to(int32_t pan_cdeg) {
  if (is_stepper(settings_)) {
    stepper_.turn_to(settings_, pan_cdeg);
  } else {
    turning_ms_ = servo_.turn_to(settings_, pan_cdeg);
  }
}

bool PanDrive::tick() {
  if (is_stepper(settings_)) {
    return stepper_.tick(pins_);
  }
  if (turning_ms_ != 0) {
    --turning_ms_;
  }
  return turning_ms_ == 0;
}

void PanDrive::rest() {
  if (is_stepper(settings_)) {
    stepper_.rest(pins_);
  } else if (turning_ms_ != 0) {
    servo_.lose_track();
  }
}

}  // namespace drivers
}  // namespace echomap
