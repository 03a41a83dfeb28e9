// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::world {

/// What a board puts on a wire during one period of its PWM.
struct PinSignal {
  enum class Source : std::uint8_t {
    kFloating,  ///< Nobody drives the pin, as before a program has set it up.
    kPulledUp,  ///< Only the chip's own pull-up, 20 to 50 kOhm, does.
    kDriven,
  };

  Source source = Source::kFloating;
  /// The driven pin is high between these shares of the period, 0 .. 1; all of it is a level.
  double high_from = 0.0;
  double high_until = 0.0;
  /// Of pulses, microseconds; 0 of a level.
  double period_us = 0.0;

  /// Share of the time that the driven pin is high.
  double high_share() const { return high_until - high_from; }
  bool makes_pulses() const { return period_us > 0.0 && high_share() > 0.0 && high_share() < 1.0; }

  friend bool operator==(const PinSignal&, const PinSignal&) = default;
};

/// A pin that nobody drives.
constexpr PinSignal floating() { return {}; }
/// An input with the chip's pull-up.
constexpr PinSignal pulled_up() { return {PinSignal::Source::kPulledUp, 0.0, 0.0, 0.0}; }
/// An output that does not change.
constexpr PinSignal level(bool high) {
  return {PinSignal::Source::kDriven, 0.0, high ? 1.0 : 0.0, 0.0};
}
/// High at the beginning of each period, for the share `high` of it.
constexpr PinSignal pulses(double high, double period_us) {
  return {PinSignal::Source::kDriven, 0.0, high, period_us};
}
/// Low at the beginning of each period, for the share `low` of it.
constexpr PinSignal inverted_pulses(double low, double period_us) {
  return {PinSignal::Source::kDriven, low, 1.0, period_us};
}

}  // namespace echomap::world
