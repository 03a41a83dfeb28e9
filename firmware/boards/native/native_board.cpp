// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_board.hpp"

#include <algorithm>
#include <new>

#include "firmware/app/robot.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace native {
namespace {

constexpr std::int64_t kTickNs = 1000000000 / hal::kTickHz;
/// 13 cycles of 125 kHz, the ATmega's.
constexpr std::int64_t kConversionNs = 104000;

/// Whose program is in the memory, where that is known.
NativeBoard* in_memory = nullptr;

void run_program() {
  while (app::robot.run_once()) {
  }
}

}  // namespace

NativeBoard& NativeBoard::instance() {
  static NativeBoard first;
  return in_memory == nullptr ? first : *in_memory;
}

NativeBoard::~NativeBoard() {
  if (in_memory == this) {
    in_memory = nullptr;
  }
}

void NativeBoard::take_memory() {
  if (in_memory == this) {
    return;
  }
  if (in_memory != nullptr) {
    in_memory->memory_ = ProgramMemory::copy();
  }
  if (memory_) {
    memory_->restore();
  }
  in_memory = this;
}

void NativeBoard::power_on() {
  now_ns_ = 0;
  starts_ = 0;
  encoder_levels_ = 0;
  watchdog_kicks_ = 0;
  start_program();
}

void NativeBoard::start_program() {
  take_memory();
  events_.clear();
  line_.clear();
  started_ns_ = now_ns_;
  ++starts_;
  sending_ = false;
  echo_high_ = false;
  left_duty_ = 0;
  right_duty_ = 0;
  left_brakes_ = false;
  right_brakes_ = false;
  bridge_kind_ = hal::BridgeKind::kPhaseEnable;
  has_slow_pwm_ = false;
  pan_pulse_us_ = 0.0;
  aux_uses_.fill(hal::PinUse::kUnused);
  aux_outputs_.fill(false);
  conversion_end_ns_ = 0;
  counted_pulses_ = 0;
  two_wire.stop();
  boards::start_edge_count(encoder_levels_);
  new (&app::devices) app::Devices();
  new (&app::robot) app::Robot(app::devices);
  app::robot.start();
  at(now_ns_ + kTickNs, [this] { tick(); });
}

void NativeBoard::run_until_ns(std::int64_t until_ns) {
  take_memory();
  while (!events_.empty() && events_.begin()->first <= until_ns) {
    const auto node = events_.extract(events_.begin());
    now_ns_ = std::max(now_ns_, node.key());
    node.mapped()();
    run_program();
  }
  now_ns_ = std::max(now_ns_, until_ns);
}

void NativeBoard::receive(const std::uint8_t* bytes, std::size_t size) {
  const bool line_idle = line_.empty();
  line_.insert(line_.end(), bytes, bytes + size);
  if (line_idle && !line_.empty()) {
    at(now_ns_ + kByteNs, [this] { deliver_byte(); });
  }
}

void NativeBoard::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  at(rise_ns, [this] { set_echo(true); });
  at(fall_ns, [this] { set_echo(false); });
}

void NativeBoard::schedule_encoder_edge(bool right, std::int64_t at_ns, bool a, bool b) {
  at(at_ns, [this, right, a, b] { set_encoder(right, a, b); });
}

void NativeBoard::set_bump(bool right, bool closed) {
  const unsigned bit = right ? hal::kContactRight : hal::kContactLeft;
  const unsigned others = closed_contacts_ & ~bit;
  closed_contacts_ = static_cast<std::uint8_t>(closed ? others | bit : others);
}

void NativeBoard::set_aux_level(std::uint8_t pin, bool high) {
  const unsigned bit = 1U << pin;
  const unsigned others = aux_low_ & ~bit;
  if (!high && (aux_low_ & bit) == 0 && aux_uses_.at(pin) == hal::PinUse::kPulses) {
    ++counted_pulses_;
  }
  aux_low_ = static_cast<std::uint16_t>(high ? others : others | bit);
}

void NativeBoard::schedule_aux_pulse(std::uint8_t pin, std::int64_t fall_ns, std::int64_t rise_ns) {
  at(fall_ns, [this, pin] { set_aux_level(pin, false); });
  at(rise_ns, [this, pin] { set_aux_level(pin, true); });
}

void NativeBoard::use_aux_pin(std::uint8_t pin, hal::PinUse use) {
  set_aux_output(pin, false);
  aux_uses_.at(pin) = use;
}

std::uint16_t NativeBoard::aux_levels() const {
  unsigned levels = 0;
  for (unsigned pin = 0; pin < kAuxPins; ++pin) {
    if (aux_uses_[pin] == hal::PinUse::kDigital) {
      levels |= 1U << pin;
    }
  }
  return static_cast<std::uint16_t>(levels & ~aux_low_);
}

void NativeBoard::set_aux_output(std::uint8_t pin, bool high) {
  if (aux_outputs_.at(pin) == high) {
    return;
  }
  aux_outputs_[pin] = high;
  if (on_aux_output) {
    on_aux_output(now_ns_, pin, high);
  }
}

void NativeBoard::start_conversion(std::uint8_t pin) {
  converted_ = aux_analog_.at(pin);
  conversion_end_ns_ = now_ns_ + kConversionNs;
}

bool NativeBoard::conversion_done(std::uint16_t& value) const {
  value = converted_;
  return now_ns_ >= conversion_end_ns_;
}

void NativeBoard::use_bridge(hal::BridgeKind kind, bool slow_pwm) {
  bridge_kind_ = kind;
  has_slow_pwm_ = slow_pwm;
  set_motor(hal::Motor::kLeft, 0, false);
  set_motor(hal::Motor::kRight, 0, false);
}

void NativeBoard::set_motor(hal::Motor motor, std::int16_t duty, bool brakes) {
  const bool left = motor == hal::Motor::kLeft;
  (left ? left_duty_ : right_duty_) = duty;
  (left ? left_brakes_ : right_brakes_) = brakes;
  if (on_motor) {
    on_motor();
  }
}

void NativeBoard::trigger_sonar() {
  if (on_trigger) {
    on_trigger(now_ns_);
  }
}

void NativeBoard::request_send() {
  std::uint8_t byte = 0;
  if (!sending_ && hal::next_byte_to_send(byte)) {
    sending_ = true;
    at(now_ns_ + kByteNs, [this, byte] { finish_byte(byte); });
  }
}

void NativeBoard::tick() {
  at(now_ns_ + kTickNs, [this] { tick(); });
  boards::fold_edges();
  hal::on_tick();
}

void NativeBoard::deliver_byte() {
  const std::uint8_t byte = line_.front();
  line_.pop_front();
  if (!line_.empty()) {
    at(now_ns_ + kByteNs, [this] { deliver_byte(); });
  }
  hal::on_byte_received(byte);
}

void NativeBoard::finish_byte(std::uint8_t byte) {
  sending_ = false;
  request_send();
  if (on_sent) {
    on_sent(byte);
  }
}

void NativeBoard::set_echo(bool high) {
  echo_high_ = high;
  hal::on_echo_edge(high, static_cast<std::uint32_t>(program_ns() / 500));
}

void NativeBoard::set_encoder(bool right, bool a, bool b) {
  const unsigned shift = right ? 2 : 0;
  const unsigned levels = (a ? 1U : 0U) | (b ? 2U : 0U);
  const unsigned others = encoder_levels_ & ~(3U << shift);
  encoder_levels_ = static_cast<std::uint8_t>(others | (levels << shift));
  boards::count_edges(encoder_levels_);
}

}  // namespace native
}  // namespace echomap
