// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

#include "host/fleet_messages/messages.hpp"
#include "host/fleet_messages/table_rows.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::fleet_messages {

/// Unit of the angles in messages, radians: a full turn is 2^16 of them.
inline constexpr double kAngleUnitRad = geometry::kFullTurnRad / 65536.0;

/// Rounds metres, seconds and radians to whole numbers, and notes whether all of them fitted.
class Quantiser {
 public:
  /// The nearest whole number; 0 where it is out of the type's range or not a number.
  template <std::integral T>
    requires(sizeof(T) <= 4)
  T nearest(double value) {
    return static_cast<T>(nearest_between(
        value, std::numeric_limits<T>::min(), std::int64_t{std::numeric_limits<T>::max()}));
  }
  template <std::integral T>
  T thousandths(double value) {
    return nearest<T>(1000.0 * value);
  }
  /// The nearest whole number, at most the largest of its type.
  template <std::integral T>
  T saturated(double value) {
    return nearest<T>(std::min(value, static_cast<double>(std::numeric_limits<T>::max())));
  }
  /// The stamp in milliseconds.
  std::uint64_t stamp_ms(double stamp_s) {
    return static_cast<std::uint64_t>(
        nearest_between(1000.0 * stamp_s, 0, static_cast<std::int64_t>(kMaxStampMs)));
  }
  /// The range in millimetres.
  std::uint16_t range_mm(double range_m) {
    return static_cast<std::uint16_t>(
        nearest_between(1000.0 * range_m, 0, ReadingRow::kNoRange - 1));
  }
  /// A direction in angle units, modulo full turns.
  std::uint16_t direction(double angle_rad) {
    return static_cast<std::uint16_t>(nearest<std::int32_t>(angle_rad / kAngleUnitRad));
  }
  /// A rotation in angle units, which may exceed a full turn.
  std::int32_t turn(double turn_rad) { return nearest<std::int32_t>(turn_rad / kAngleUnitRad); }
  PoseRow pose(const geometry::Pose2& pose) {
    return {thousandths<std::int32_t>(pose.x_m()),
            thousandths<std::int32_t>(pose.y_m()),
            direction(pose.heading_rad())};
  }

  /// Whether every number so far was in the range of its type.
  bool fits() const { return fits_; }

 private:
  std::int64_t nearest_between(double value, std::int64_t min, std::int64_t max) {
    const double rounded = std::round(value);
    const bool fits = rounded >= static_cast<double>(min) && rounded <= static_cast<double>(max);
    fits_ = fits_ && fits;
    return fits ? static_cast<std::int64_t>(rounded) : 0;
  }

  bool fits_ = true;
};

/// Converts a direction back to radians, in (-pi, pi].
inline double to_direction_rad(std::uint16_t direction) {
  const std::int32_t signed_direction = direction > 32768 ? direction - 65536 : direction;
  return kAngleUnitRad * signed_direction;
}

/// Converts a row back to a pose in metres and radians.
inline geometry::Pose2 to_pose(const PoseRow& row) {
  return {row.x_mm / 1000.0, row.y_mm / 1000.0, to_direction_rad(row.heading)};
}

}  // namespace echomap::fleet_messages
