// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/localization/pose_measurement.hpp"

namespace echomap::localization {

/// What has become of an odometry pose or a measurement that a Kalman filter was given.
enum class EkfOutcome : std::uint8_t {
  kApplied,
  kHeld,           ///< Ahead of the odometry: it is judged when the odometry gets there.
  kGated,          ///< Farther off than the gate.
  kTooOld,         ///< Older than the history.
  kTimeRanBack,    ///< Odometry not after the last; the next one says what it would have.
  kNotFinite,      ///< A number is none.
  kBadRange,       ///< A range that is not above 0.
  kBadCovariance,  ///< Not positive definite.
  kAtLandmark,     ///< The robot believes to stand on the landmark, which has no bearing there.
  kTooManyHeld,
};
inline constexpr std::size_t kEkfOutcomes = 10;

/// The outcome of a measurement with that fault.
EkfOutcome outcome_of(MeasurementFault fault);

}  // namespace echomap::localization
