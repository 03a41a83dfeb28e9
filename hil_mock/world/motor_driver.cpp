// SPDX-License-Identifier: MIT
#include "hil_mock/world/motor_driver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/files/nearest_word.hpp"

namespace echomap::world {
namespace {

constexpr std::array<std::pair<DriverChip, const char*>, 10> kDriverNames = {
    {{DriverChip::kPhaseEnable, "phase-enable"},
     {DriverChip::kDrv8835, "drv8835"},
     {DriverChip::kDrv8835InIn, "drv8835-in-in"},
     {DriverChip::kTb6612fng, "tb6612fng"},
     {DriverChip::kL298n, "l298n"},
     {DriverChip::kL293d, "l293d"},
     {DriverChip::kDrv8833, "drv8833"},
     {DriverChip::kMx1508, "mx1508"},
     {DriverChip::kMdd3a, "mdd3a"},
     {DriverChip::kServo, "servo"}}};

/// L293D: "PWM up to 5 kHz".
constexpr double kL293dMinPeriodUs = 200.0;

/// A servo's pulses: it stands at the middle and turns at full speed this far from it.
constexpr double kServoMiddleUs = 1500.0;
constexpr double kServoFullUs = 500.0;
constexpr double kServoDeadBandUs = 15.0;
/// A pulse beyond full speed and this far is noise, and so is one at another pace than 50 Hz.
constexpr double kServoMarginUs = 300.0;
constexpr double kServoMinPeriodUs = 5'000.0;
constexpr double kServoMaxPeriodUs = 30'000.0;

bool is_high(const PinSignal& pin, double at) { return at >= pin.high_from && at < pin.high_until; }

double servo_duty(const PinSignal& pin) {
  const double off_us = pin.high_share() * pin.period_us - kServoMiddleUs;
  const bool is_pulse = pin.source == PinSignal::Source::kDriven && pin.makes_pulses() &&
                        pin.period_us >= kServoMinPeriodUs && pin.period_us <= kServoMaxPeriodUs &&
                        std::abs(off_us) <= kServoFullUs + kServoMarginUs;
  if (!is_pulse || std::abs(off_us) <= kServoDeadBandUs) {
    return 0.0;
  }
  return std::clamp(off_us / kServoFullUs, -1.0, 1.0);
}

/// IN1, IN2 and an enable, without which the chip lets go of the motor.
BridgeState enabled_bridge(const InputLevels& levels) {
  if (!levels.pwm) {
    return BridgeState::kCoast;
  }
  if (levels.in1 == levels.in2) {
    return BridgeState::kBrake;
  }
  return levels.in1 ? BridgeState::kForward : BridgeState::kReverse;
}

BridgeState tb6612_bridge(const InputLevels& levels) {
  if (!levels.in1 && !levels.in2) {
    return BridgeState::kCoast;
  }
  if (!levels.pwm || levels.in1 == levels.in2) {
    return BridgeState::kBrake;
  }
  return levels.in1 ? BridgeState::kForward : BridgeState::kReverse;
}

BridgeState phase_enable_bridge(const InputLevels& levels) {
  if (!levels.pwm) {
    return BridgeState::kBrake;
  }
  return levels.in1 ? BridgeState::kForward : BridgeState::kReverse;
}

BridgeState two_pwm_bridge(const InputLevels& levels, BridgeState both_low) {
  if (levels.in1 == levels.in2) {
    return levels.in1 ? BridgeState::kBrake : both_low;
  }
  return levels.in1 ? BridgeState::kForward : BridgeState::kReverse;
}

}  // namespace

DriverInterface MotorDriver::interface() const {
  switch (chip_) {
    case DriverChip::kTb6612fng:
    case DriverChip::kL298n:
    case DriverChip::kL293d:
      return DriverInterface::kIn1In2Pwm;
    case DriverChip::kDrv8835InIn:
    case DriverChip::kDrv8833:
    case DriverChip::kMx1508:
    case DriverChip::kMdd3a:
      return DriverInterface::kTwoPwm;
    case DriverChip::kServo:
      return DriverInterface::kServo;
    case DriverChip::kPhaseEnable:
    case DriverChip::kDrv8835:
      break;
  }
  return DriverInterface::kPhaseEnable;
}

BridgeState MotorDriver::state(const InputLevels& levels) const {
  switch (interface()) {
    case DriverInterface::kPhaseEnable:
      return phase_enable_bridge(levels);
    case DriverInterface::kIn1In2Pwm:
      return chip_ == DriverChip::kTb6612fng ? tb6612_bridge(levels) : enabled_bridge(levels);
    case DriverInterface::kTwoPwm:
      return two_pwm_bridge(
          levels, chip_ == DriverChip::kMdd3a ? BridgeState::kBrake : BridgeState::kCoast);
    case DriverInterface::kServo:
      break;
  }
  throw std::logic_error("a servo has pulses, no levels");
}

MotorDrive MotorDriver::drive(const DriverInputs& inputs) const {
  if (interface() == DriverInterface::kServo) {
    return {servo_duty(inputs.pwm), 0.0};
  }
  const PinSignal pwm = seen(inputs.pwm, true);
  const PinSignal in1 = seen(inputs.in1, false);
  const PinSignal in2 = seen(inputs.in2, false);
  std::array<double, 8> ends{
      0.0, pwm.high_from, pwm.high_until, in1.high_from, in1.high_until, in2.high_from};
  ends[6] = in2.high_until;
  ends[7] = 1.0;
  std::sort(ends.begin(), ends.end());
  MotorDrive mean;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double share = ends.at(i + 1) - ends.at(i);
    if (share <= 0.0) {
      continue;
    }
    const double at = ends.at(i);
    const BridgeState now = state({is_high(pwm, at), is_high(in1, at), is_high(in2, at)});
    mean.duty += now == BridgeState::kForward ? share : now == BridgeState::kReverse ? -share : 0.0;
    mean.coasting += now == BridgeState::kCoast ? share : 0.0;
  }
  for (const PinSignal& pin : {pwm, in1, in2}) {
    if (pin.makes_pulses() && pin.period_us < min_period_us()) {
      mean.duty = 0.0;
    }
  }
  return mean;
}

/// ST's L298N and the L293D source current at their inputs. The drawing asks for 10 kOhm to ground
/// at the enables.
bool MotorDriver::floats_high(bool is_enable) const {
  const bool sources_current = chip_ == DriverChip::kL298n || chip_ == DriverChip::kL293d;
  return sources_current && !(is_enable && pull_downs_);
}

/// Against 100 kOhm and more inside of these chips; others have 10 kOhm, on the board or inside.
bool MotorDriver::pull_up_wins() const {
  return chip_ != DriverChip::kPhaseEnable && chip_ != DriverChip::kMx1508;
}

PinSignal MotorDriver::seen(const PinSignal& pin, bool is_enable) const {
  const bool sources_current = chip_ == DriverChip::kL298n || chip_ == DriverChip::kL293d;
  switch (pin.source) {
    case PinSignal::Source::kDriven:
      break;
    case PinSignal::Source::kPulledUp:
      return level(sources_current ? floats_high(is_enable) : pull_up_wins());
    case PinSignal::Source::kFloating:
      return level(floats_high(is_enable));
  }
  return pin;
}

double MotorDriver::min_period_us() const {
  return chip_ == DriverChip::kL293d ? kL293dMinPeriodUs : 0.0;
}

DriverInputs inputs_for(DriverInterface interface, double duty, bool brake, double period_us) {
  constexpr double kServoPeriodUs = 20'000.0;
  const double size = std::abs(duty);
  const bool forward = duty > 0.0;
  switch (interface) {
    case DriverInterface::kPhaseEnable:
      return {pulses(size, period_us), level(forward), floating()};
    case DriverInterface::kIn1In2Pwm:
      if (duty == 0.0) {
        return {level(brake), level(brake), level(brake)};
      }
      return {pulses(size, period_us), level(forward), level(!forward)};
    case DriverInterface::kTwoPwm:
      if (duty == 0.0) {
        return {floating(), level(brake), level(brake)};
      }
      return forward ? DriverInputs{floating(), pulses(size, period_us), level(false)}
                     : DriverInputs{floating(), inverted_pulses(size, period_us), level(true)};
    case DriverInterface::kServo:
      break;
  }
  const double pulse_us = kServoMiddleUs + kServoFullUs * duty;
  return {duty == 0.0 && !brake ? level(false) : pulses(pulse_us / kServoPeriodUs, kServoPeriodUs),
          floating(),
          floating()};
}

std::string_view name_of(DriverChip chip) {
  return std::find_if(kDriverNames.begin(),
                      kDriverNames.end(),
                      [chip](const auto& entry) { return entry.first == chip; })
      ->second;
}

DriverChip driver_named(const std::string& name) {
  for (const auto& [chip, word] : kDriverNames) {
    if (name == word) {
      return chip;
    }
  }
  throw std::invalid_argument("unknown motor driver '" + name + "'" +
                              files::suggestion(name, driver_names()));
}

std::vector<std::string> driver_names() {
  std::vector<std::string> names;
  for (const auto& [chip, word] : kDriverNames) {
    names.emplace_back(word);
  }
  return names;
}

}  // namespace echomap::world
