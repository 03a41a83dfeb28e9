// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/telemetry_messages.hpp"

namespace echomap::sensors {

/// What a scalar sensor puts on its pin.
enum class ScalarKind : std::uint8_t {
  kPulses,  ///< One for each event: a Geiger tube.
  kLevel,   ///< A voltage: light, gas.
};

/// A scalar sensor of a robot's profile.
struct ScalarParams {
  ScalarKind kind = ScalarKind::kPulses;
  std::string unit;  ///< Of a level, or of pulses per second, for people.
  /// Of pulses: how long after one the sensor notices no other (non-paralysable, Knoll 2010,
  /// section 4.VII), and what it counts without a source, where the profile says so.
  double dead_time_s = 0.0;
  std::optional<double> background_per_s;
  /// Of a level: the unit's value at the converter's first and last count.
  double zero = 0.0;
  double full_scale = 1023.0;
};

/// What a scalar sensor has said between two messages.
struct ScalarReading {
  double count = 0.0;    ///< Pulses, or the mean level in the sensor's unit.
  double dwell_s = 0.0;  ///< For how long pulses were counted; 0 of a level.
};

/// Turns the board's cumulative sums into readings. What lost messages would have told is in the
/// next reading.
class ScalarMeter {
 public:
  /// Throws std::invalid_argument for a negative dead time or background, and for a level whose
  /// scale has no length.
  explicit ScalarMeter(const ScalarParams& params);

  /// Takes messages in their order. Empty for the first since the robot's start, for one that is no
  /// later than the last, for a level without a conversion, and after a gap of a minute, in which
  /// the number of conversions may have wrapped.
  std::optional<ScalarReading> update(const protocol::Scalar& message);
  /// The robot was reset: its sums start at zero.
  void restart() { last_.reset(); }

 private:
  ScalarParams params_;
  std::optional<protocol::Scalar> last_;
};

}  // namespace echomap::sensors
