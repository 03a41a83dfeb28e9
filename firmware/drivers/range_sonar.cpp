// SPDX-License-Identifier: MIT
#include "firmware/drivers/range_sonar.hpp"

#include "firmware/hal/range_sensor.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace drivers {
namespace {

uint16_t flight_of(uint16_t range_mm) {
  constexpr uint32_t kUsPerMmAtOneDmPerS = 20000;  // There and back.
  const uint32_t scaled = range_mm * kUsPerMmAtOneDmPerS + hal::kRangeSoundDmPerS / 2;
  return static_cast<uint16_t>(scaled / hal::kRangeSoundDmPerS);
}

}  // namespace

void RangeSonar::ping(uint32_t now_us) {
  pinged_us_ = now_us;
  listening_ = true;
}

bool RangeSonar::poll(uint32_t now_us, uint16_t max_echo_us, uint16_t& flight_us) {
  if (!listening_) {
    return false;
  }
  const hal::RangeReading reading = hal::read_range();
  const bool is_absent = reading.state == hal::RangeReading::State::kAbsent;
  if (!is_absent && now_us - pinged_us_ < uint32_t{reading.greatest_age_ms} * 1000) {
    return false;
  }
  listening_ = false;
  flight_us = is_absent ? protocol::kNoSonar : protocol::kNoEcho;
  if (reading.state == hal::RangeReading::State::kRange) {
    const uint16_t flight = flight_of(reading.range_mm);
    flight_us = flight <= max_echo_us ? flight : protocol::kNoEcho;
  }
  return true;
}

}  // namespace drivers
}  // namespace echomap
