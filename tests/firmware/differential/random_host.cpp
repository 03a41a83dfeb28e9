// SPDX-License-Identifier: MIT
#include "tests/firmware/differential/random_host.hpp"

#include "firmware/hal/events.hpp"
#include "protocol/limits.hpp"
#include "protocol/messages.hpp"
#include "protocol/version.hpp"

namespace echomap {
namespace differential {
namespace {

constexpr uint8_t kOpeningMessages = 8;
constexpr uint8_t kLog2StepsPerOpening = 10;

int32_t with_sign(uint16_t drawn, int32_t value) { return (drawn & 1U) != 0 ? -value : value; }

}  // namespace

bool RandomHost::step() {
  if (opening_ < kOpeningMessages) {
    begin();
    return opening_ == 1;
  }
  const uint16_t drawn = random_.bits16();
  if ((drawn & ((1U << kLog2StepsPerOpening) - 1)) == 0) {
    opening_ = 0;
  } else if ((drawn >> 13) == 0) {
    send_anything();
  }
  return false;
}

template <class M>
void RandomHost::send(const M& message) {
  const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
  const uint16_t drawn = random_.bits16();
  const uint8_t damaged = static_cast<uint8_t>((drawn & 0xFFU) < 2 ? (drawn >> 8) & 15U : 0xFFU);
  for (uint8_t i = 0; i < frame.size; ++i) {
    hal::on_byte_received(static_cast<uint8_t>(frame.data[i] ^ (i == damaged ? 0x10U : 0U)));
  }
}

void RandomHost::begin() {
  switch (opening_++) {
    case 0:
      send(protocol::Hello{protocol::kProtocolMajor,
                           protocol::kProtocolMinor,
                           protocol::kSchemaDigest,
                           static_cast<uint16_t>(1 + (random_.bits16() & 1U))});
      break;
    case 1:
      send(protocol::Arm{next_id(), 0});
      break;
    case 2:
      send_drive_settings();
      break;
    case 3:
      send_safety_settings();
      break;
    case 4:
      send_pin_settings();
      break;
    case 5:
      send_pan_settings();
      break;
    case 6:
      if (random_.once_in(1)) {
        send_wiring();
      } else {
        send(protocol::ConfigureSonar{next_id(), random_.wide(), random_.bits8()});
      }
      break;
    default:
      send(protocol::Arm{next_id(), 1});
      break;
  }
}

void RandomHost::send_anything() {
  switch (random_.bits8() & 31U) {
    case 0:
      send(protocol::Stop{next_id()});
      break;
    case 1:
      send(protocol::Arm{next_id(), static_cast<uint8_t>(random_.bits8() & 1U)});
      break;
    case 2:
      send(protocol::Ping{random_.next()});
      break;
    case 3:
      send(protocol::BulkRead{static_cast<uint8_t>(random_.bits8() & 3U), random_.wide()});
      break;
    case 4: {
      const uint16_t drawn = random_.bits16();
      send(protocol::ConfigureSensors{next_id(),
                                      static_cast<uint8_t>(drawn & 0x1FU),
                                      static_cast<uint8_t>((drawn >> 5) & 0x1FU),
                                      static_cast<uint8_t>((drawn >> 10) & 3U)});
      break;
    }
    case 5:
    case 6:
    case 7:
    case 8:
      send_sweep();
      break;
    case 9:
    case 10:
    case 11:
      send(protocol::Arm{next_id(), 1});
      break;
    case 12:
      send(protocol::ConfigureScalar{next_id(), static_cast<uint16_t>(random_.bits16() & 0xFFFU)});
      break;
    default:
      send_motion();
      break;
  }
}

void RandomHost::send_motion() {
  const uint16_t drawn = random_.bits16();
  const uint8_t kind = drawn & 7U;
  if (kind < 4) {
    send(protocol::DriveSetpoint{speed(), speed(), time_to_live_ms()});
  } else if (kind < 6) {
    send(protocol::KeepAlive{time_to_live_ms()});
  } else {
    const uint8_t shift = (drawn >> 3) & 7U;
    const int32_t left = with_sign(drawn >> 6, int32_t{random_.wide()} << shift);
    const int32_t right = with_sign(drawn >> 7, int32_t{random_.wide()} << shift);
    const uint16_t ticks_per_s = random_.wide();
    send(protocol::MoveTicks{next_id(), left, right, ticks_per_s, time_to_live_ms()});
  }
}

void RandomHost::send_drive_settings() {
  const bool usual = !random_.once_in(2);
  protocol::ConfigureDrive settings{};
  settings.command_id = next_id();
  const uint8_t inversions = random_.bits8();
  settings.inversions = (inversions & 0x80U) != 0 ? inversions & 0x0FU : 0U;
  settings.max_ticks_per_s =
      usual ? static_cast<uint16_t>(500 + random_.below(31501)) : random_.wide();
  settings.max_ticks_per_s2 = random_.wide() | 1U;
  settings.feed_forward = usual ? random_.below(64) : random_.wide();
  settings.proportional = usual ? random_.below(64) : random_.wide();
  settings.integral = usual ? random_.below(512) : random_.wide();
  settings.odometry_period_ms = static_cast<uint8_t>(1 + (random_.bits8() & 0x1FU));
  send(settings);
}

void RandomHost::send_safety_settings() {
  protocol::ConfigureSafety settings{};
  settings.command_id = next_id();
  settings.hazard_stops = random_.bits8();
  settings.stall_ms = random_.once_in(1) ? uint16_t{0} : random_.below(1001);
  settings.runaway_ticks = random_.once_in(1) ? uint16_t{0} : random_.below(32001);
  settings.over_speed_ticks_per_s = random_.once_in(1) ? uint16_t{0} : random_.wide();
  send(settings);
}

/// Now and then one that is refused.
void RandomHost::send_wiring() {
  const uint8_t drawn = random_.bits8();
  send(protocol::ConfigureWiring{next_id(),
                                 static_cast<uint8_t>((drawn & 7U) % 5U),
                                 static_cast<uint8_t>((drawn >> 3) & 3U),
                                 static_cast<uint8_t>((drawn >> 5) & 3U)});
}

void RandomHost::send_pan_settings() {
  const uint16_t drawn = random_.bits16();
  const bool stepper = (drawn & 1U) != 0;
  const int32_t span_cdeg = int32_t{random_.below(18001)} * (stepper ? 4 : 1);
  protocol::ConfigurePan settings{};
  settings.command_id = next_id();
  settings.kind =
      static_cast<uint8_t>(stepper ? protocol::PanKind::kStepper : protocol::PanKind::kServo);
  settings.centre_us = static_cast<uint16_t>(1400 + random_.below(200));
  settings.us_per_90deg = static_cast<int16_t>(with_sign(drawn >> 1, random_.below(1000)));
  settings.steps_per_turn = static_cast<int16_t>(with_sign(drawn >> 2, random_.below(8193)));
  settings.min_cdeg = -span_cdeg;
  settings.max_cdeg = span_cdeg;
  settings.deg_per_s = (drawn & 8U) != 0 ? random_.wide() : random_.below(400);
  send(settings);
}

uint8_t RandomHost::pin_function() {
  const uint8_t drawn = random_.bits8();
  if (drawn < 160) {
    return protocol::kPinUnused;
  }
  if (drawn < 208) {
    return static_cast<uint8_t>(1U + (drawn & 7U) % 7U) | (drawn & 0x10U ? 0x80U : 0U);
  }
  return (drawn & 1U) != 0 ? static_cast<uint8_t>(protocol::kPinRange0 + ((drawn >> 1) & 7U))
                           : static_cast<uint8_t>(protocol::kPinBattery + (drawn >> 1) % 3U);
}

void RandomHost::send_pin_settings() {
  protocol::ConfigurePins settings{};
  settings.command_id = next_id();
  if (random_.once_in(1)) {
    settings.pin_0 = protocol::kPinStepperPhaseA;
    settings.pin_1 = protocol::kPinStepperPhaseA + 1;
    settings.pin_2 = protocol::kPinStepperPhaseA + 2;
    settings.pin_3 = protocol::kPinStepperPhaseA + 3;
  }
  settings.pin_4 = pin_function();
  settings.pin_5 = pin_function();
  settings.pin_7 = pin_function();
  settings.pin_9 = pin_function();
  settings.pin_12 = pin_function();
  settings.pin_15 = pin_function();
  send(settings);
}

void RandomHost::send_sweep() {
  const uint16_t drawn = random_.bits16();
  const uint8_t shift = (drawn >> 8) & 3U;
  const int32_t from = with_sign(drawn, int32_t{random_.below(18001)} << shift);
  const int32_t to = with_sign(drawn >> 1, int32_t{random_.below(18001)} << shift);
  const int32_t size = int32_t{random_.wide()} >> ((drawn >> 3) & 7U);
  const int32_t step = (drawn & 4U) != 0 ? -size : size;
  const uint16_t settle_ms = static_cast<uint16_t>(random_.wide() >> ((drawn >> 11) & 15U));
  send(protocol::StartSweep{next_id(), from, to, step, settle_ms});
}

/// Now and then that of the last command.
uint8_t RandomHost::next_id() {
  if (!random_.once_in(5)) {
    command_id_ = static_cast<uint8_t>(command_id_ == 0xFF ? 1 : command_id_ + 1);
  }
  return command_id_;
}

uint16_t RandomHost::time_to_live_ms() {
  return random_.once_in(4) ? random_.wide() : random_.below(501);
}

int16_t RandomHost::speed() { return static_cast<int16_t>(random_.wide()); }

}  // namespace differential
}  // namespace echomap
