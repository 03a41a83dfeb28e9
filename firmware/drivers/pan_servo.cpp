// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_servo.hpp"

#include "firmware/hal/servo.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace drivers {
namespace {

int32_t pulse_us(const protocol::ConfigurePan& settings, int32_t pan_cdeg) {
  return settings.centre_us + settings.us_per_90deg * pan_cdeg / 9000;
}

bool pulse_in_range(int32_t pulse) {
  return pulse >= protocol::kMinServoPulseUs && pulse <= protocol::kMaxServoPulseUs;
}

}  // namespace

bool PanServo::accepts(const protocol::ConfigurePan& settings) {
  return pulse_in_range(pulse_us(settings, settings.min_cdeg)) &&
         pulse_in_range(pulse_us(settings, settings.max_cdeg));
}

uint16_t PanServo::turn_to(const protocol::ConfigurePan& settings, int32_t pan_cdeg) {
  const int32_t pulse = pulse_us(settings, pan_cdeg);
  int32_t turn_cdeg = settings.max_cdeg - settings.min_cdeg;
  if (pan_known_) {
    if (pulse == pulse_us(settings, pan_cdeg_)) {
      return 0;
    }
    turn_cdeg = pan_cdeg - pan_cdeg_;
  }
  pan_cdeg_ = pan_cdeg;
  pan_known_ = true;
  hal::set_servo_pulse_us(static_cast<uint16_t>(pulse));
  const uint32_t travel_cdeg = static_cast<uint32_t>(turn_cdeg < 0 ? -turn_cdeg : turn_cdeg);
  const uint16_t speed = settings.deg_per_s;
  const uint32_t travel_ms = (travel_cdeg * 10 + speed - 1) / speed;
  return static_cast<uint16_t>(hal::kServoFrameMs +
                               (travel_ms > kMaxTravelMs ? kMaxTravelMs : travel_ms));
}

}  // namespace drivers
}  // namespace echomap
