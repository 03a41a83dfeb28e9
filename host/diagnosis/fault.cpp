// SPDX-License-Identifier: MIT
#include "host/diagnosis/fault.hpp"

namespace echomap::diagnosis {

bool forbids_a_map(FaultKind kind) {
  switch (kind) {
    case FaultKind::kNone:
    case FaultKind::kWheelSize:
    case FaultKind::kPanOffset:
    case FaultKind::kRangeScale:
    case FaultKind::kLeftDirty:
    case FaultKind::kRightDirty:
      return false;
    default:
      return true;
  }
}

const char* name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::kNone:
      return "none";
    case FaultKind::kLeftWheelSize:
      return "left-wheel-size";
    case FaultKind::kRightWheelSize:
      return "right-wheel-size";
    case FaultKind::kWheelSize:
      return "wheel-size";
    case FaultKind::kLeftCounts:
      return "left-counts";
    case FaultKind::kRightCounts:
      return "right-counts";
    case FaultKind::kCounts:
      return "counts";
    case FaultKind::kLeftReversed:
      return "left-wheel-reversed";
    case FaultKind::kRightReversed:
      return "right-wheel-reversed";
    case FaultKind::kBothReversed:
      return "both-wheels-reversed";
    case FaultKind::kNotMoving:
      return "not-moving";
    case FaultKind::kPanReversed:
      return "pan-reversed";
    case FaultKind::kPanOffset:
      return "pan-offset";
    case FaultKind::kRangeScale:
      return "range-scale";
    case FaultKind::kLeftAgainst:
      return "left-wheel-against-command";
    case FaultKind::kRightAgainst:
      return "right-wheel-against-command";
    case FaultKind::kBothAgainst:
      return "both-wheels-against-command";
    case FaultKind::kLeftStands:
      return "left-wheel-stands";
    case FaultKind::kRightStands:
      return "right-wheel-stands";
    case FaultKind::kLeftDirty:
      return "left-encoder-dirty";
    case FaultKind::kRightDirty:
      return "right-encoder-dirty";
  }
  return "none";
}

}  // namespace echomap::diagnosis
