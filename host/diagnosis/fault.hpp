// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::diagnosis {

/// What may be wrong with a robot or its profile.
enum class FaultKind : std::uint8_t {
  kNone,
  kLeftWheelSize,   ///< `value`: true size over that of the profile, against the other wheel's.
  kRightWheelSize,  ///< The same.
  kWheelSize,       ///< The same of both.
  kLeftCounts,      ///< `value`: counts a turn over those of the profile, about 0.5 or 2.
  kRightCounts,     ///< The same.
  kCounts,          ///< The same of both.
  kLeftReversed,    ///< Motor and encoder of the wheel.
  kRightReversed,   ///< The same.
  kBothReversed,    ///< The same of both.
  kNotMoving,       ///< The wheels turn and the robot stays.
  kPanReversed,     ///< The pan; or left and right wheel, motors and encoders, are exchanged.
  kPanOffset,       ///< `value`: the true zero, radians to the left.
  kRangeScale,      ///< `value`: true range over that by the profile.
  kLeftAgainst,     ///< Motor or encoder of the wheel is reversed, and not the other one.
  kRightAgainst,    ///< The same.
  kBothAgainst,     ///< The same of both; or the two motors, or the encoders, are exchanged.
  kLeftStands,      ///< The wheel is blocked, or its motor or its encoder is dead.
  kRightStands,     ///< The same.
  kLeftDirty,       ///< The encoder misses edges; `value`: the share of its counts that is lost.
  kRightDirty,      ///< The same.
};

/// A fault, and by how much.
struct Fault {
  FaultKind kind = FaultKind::kNone;
  double value = 0.0;
};

/// No map can come of a robot with this fault.
bool forbids_a_map(FaultKind kind);

/// As summary.json says it: "left-wheel-size", "pan-reversed", ...
const char* name_of(FaultKind kind);

}  // namespace echomap::diagnosis
