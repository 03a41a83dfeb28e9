// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/output_pins.hpp"

#include <algorithm>
#include <iterator>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {

PortOutput::PortOutput(const avr_t& avr, Pin pin)
    : avr_(avr),
      port_(find_port(avr, pin.port).r_port),
      direction_(find_port(avr, pin.port).r_ddr),
      bit_(pin.bit) {}

PwmOutput::PwmOutput(const avr_t& avr, CompareUnit unit) : avr_(avr), port_(avr, unit.pin) {
  const avr_timer_t& timer = find_timer(avr, unit.timer);
  const avr_timer_comp_t& compare = timer.comp[unit.unit];
  compare_low_ = compare.r_ocr;
  compare_high_ = compare.r_ocrh;
  connection_ = compare.com;
  std::copy_n(timer.cs, std::size(clock_select_), clock_select_);
}

std::uint16_t PwmOutput::compare() const {
  const int high = compare_high_ != 0 ? avr_.data[compare_high_] : 0;
  return static_cast<std::uint16_t>(high << 8 | avr_.data[compare_low_]);
}

std::array<std::uint16_t, 4> PwmOutput::addresses() const {
  const auto [port, direction] = port_.addresses();
  return {compare_low_, static_cast<std::uint16_t>(connection_.reg), port, direction};
}

double PwmOutput::mean_level() const {
  if (makes_pulses() && is_clocked()) {
    return (compare() + 1) / 256.0;
  }
  return port_.level() ? 1.0 : 0.0;
}

bool PwmOutput::is_clocked() const {
  return std::any_of(std::begin(clock_select_), std::end(clock_select_), [this](avr_regbit_t bit) {
    return bits(bit) != 0;
  });
}

std::array<std::uint16_t, 6> MotorOutput::addresses() const {
  const auto [compare, connection, pwm_port, pwm_direction] = pwm_.addresses();
  const auto [forward_port, forward_direction] = forward_.addresses();
  return {compare, connection, pwm_port, pwm_direction, forward_port, forward_direction};
}

}  // namespace echomap::emulator
