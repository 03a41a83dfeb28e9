// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/output_pins.hpp"

#include <iterator>

#include "hil_mock/emulator/avr_machine.hpp"
#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
namespace {

constexpr double kCyclesPerUs = kClockHz / 1e6;

/// 0 of bits that a timer has not.
unsigned bits_of(const avr_t& avr, avr_regbit_t which) {
  return which.reg != 0 ? (avr.data[which.reg] >> which.bit) & which.mask : 0U;
}

/// A number whose bits are spread over registers, the lowest first.
template <std::size_t count>
unsigned number_in(const avr_t& avr, const avr_regbit_t (&bits)[count]) {
  unsigned number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    number |= bits_of(avr, bits[i]) << i;
  }
  return number;
}

std::uint16_t word_at(const avr_t& avr, std::uint16_t low, std::uint16_t high) {
  const int upper = high != 0 ? avr.data[high] : 0;
  return static_cast<std::uint16_t>(upper << 8 | avr.data[low]);
}

}  // namespace

PortOutput::PortOutput(const avr_t& avr, Pin pin)
    : avr_(avr),
      port_(find_port(avr, pin.port).r_port),
      direction_(find_port(avr, pin.port).r_ddr),
      toggles_(find_port(avr, pin.port).r_pin),
      bit_(pin.bit) {}

world::PinSignal PortOutput::signal() const {
  if (is_driven()) {
    return world::level(level());
  }
  return bit_of(port_) ? world::pulled_up() : world::floating();
}

PwmOutput::PwmOutput(const avr_t& avr, CompareUnit unit)
    : avr_(avr), timer_(find_timer(avr, unit.timer)), unit_(unit.unit), port_(avr, unit.pin) {}

std::uint16_t PwmOutput::compare() const {
  return word_at(avr_, timer_.comp[unit_].r_ocr, timer_.comp[unit_].r_ocrh);
}

std::set<std::uint16_t> PwmOutput::addresses() const {
  std::set<std::uint16_t> registers{timer_.comp[unit_].r_ocr,
                                    static_cast<std::uint16_t>(timer_.comp[unit_].com.reg),
                                    static_cast<std::uint16_t>(timer_.cs[0].reg)};
  if (timer_.r_icr != 0) {
    registers.insert(timer_.r_icr);
  }
  const auto port = port_.addresses();
  registers.insert(port.begin(), port.end());
  return registers;
}

world::PinSignal PwmOutput::signal() const {
  const double count_cycles = cycles_per_count();
  if (!makes_pulses() || count_cycles == 0.0) {
    return port_.signal();
  }
  const avr_timer_wgm_t mode = timer_.wgm_op[number_in(avr_, timer_.wgm)];
  if (mode.kind == avr_timer_wgm_normal || mode.kind == avr_timer_wgm_ctc) {
    return world::level(sets_at_match());
  }
  const std::uint32_t counts = top(mode) + 1;
  const double before_match =
      counts > compare() ? (compare() + 1) / static_cast<double>(counts) : 1.0;
  const double up_and_down = mode.kind == avr_timer_wgm_fc_pwm ? 2.0 : 1.0;
  const double period_us = up_and_down * counts * count_cycles / kCyclesPerUs;
  return sets_at_match() ? world::inverted_pulses(before_match, period_us)
                         : world::pulses(before_match, period_us);
}

/// Toggling at a match makes half of the timer's frequency: nothing of ours does.
bool PwmOutput::is_connected() const {
  return bits_of(avr_, timer_.comp[unit_].com) >= avr_timer_com_clear;
}

bool PwmOutput::sets_at_match() const {
  return bits_of(avr_, timer_.comp[unit_].com) == avr_timer_com_set;
}

/// 0 of a timer that stands still, or that counts pulses from outside.
double PwmOutput::cycles_per_count() const {
  const unsigned select = number_in(avr_, timer_.cs);
  const std::uint8_t exponent = timer_.cs_div[select];
  return select == 0 || (exponent & AVR_TIMER_EXTCLK_CHOOSE) != 0
             ? 0.0
             : static_cast<double>(std::uint32_t{1} << exponent);
}

std::uint32_t PwmOutput::top(avr_timer_wgm_t mode) const {
  switch (mode.top) {
    case avr_timer_wgm_reg_ocra:
      return word_at(avr_, timer_.comp[0].r_ocr, timer_.comp[0].r_ocrh);
    case avr_timer_wgm_reg_icr:
      return word_at(avr_, timer_.r_icr, timer_.r_icrh);
    default:
      return (std::uint32_t{1} << mode.size) - 1;
  }
}

DriverOutput::DriverOutput(const avr_t& avr, const DriverPin& pin) {
  if (pin.timer != DriverPin::kNoTimer) {
    pwm_.emplace(avr, CompareUnit{pin.timer, pin.unit, pin.pin});
  } else if (pin.pin.port != DriverPin::kNoPort) {
    port_.emplace(avr, pin.pin);
  }
}

std::set<std::uint16_t> DriverOutput::addresses() const {
  if (pwm_) {
    return pwm_->addresses();
  }
  if (!port_) {
    return {};
  }
  const auto port = port_->addresses();
  return {port.begin(), port.end()};
}

world::PinSignal DriverOutput::signal() const {
  if (pwm_) {
    return pwm_->signal();
  }
  return port_ ? port_->signal() : world::floating();
}

MotorOutput::MotorOutput(const avr_t& avr, const MotorWiring& wiring) {
  for (const DriverWires& wires : wiring) {
    drivers_.push_back(
        {DriverOutput(avr, wires.pwm), DriverOutput(avr, wires.in1), DriverOutput(avr, wires.in2)});
  }
}

std::set<std::uint16_t> MotorOutput::addresses() const {
  std::set<std::uint16_t> registers;
  for (const auto& pins : drivers_) {
    for (const DriverOutput& pin : pins) {
      registers.merge(pin.addresses());
    }
  }
  return registers;
}

world::DriverInputs MotorOutput::inputs(world::DriverInterface interface) const {
  const auto& [pwm, in1, in2] = drivers_.at(static_cast<std::size_t>(interface));
  return {pwm.signal(), in1.signal(), in2.signal()};
}

}  // namespace echomap::emulator
