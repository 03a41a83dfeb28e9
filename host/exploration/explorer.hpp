// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "host/pipeline/snapshot.hpp"

namespace echomap::exploration {

/// Turn on the spot; counter-clockwise positive, any size.
struct Turn {
  double angle_rad = 0.0;
};

/// Straight ahead, or backwards where negative.
struct Drive {
  double distance_m = 0.0;
};

/// Pan the sonar from `from_rad` to `to_rad`, both read, in steps, and wait after each.
struct Sweep {
  double from_rad = 0.0;
  double to_rad = 0.0;
  double step_rad = 0.0;
  double settle_s = 0.0;
};

/// The readings between these two are one scan (RobotPipeline::begin_scan, end_scan).
struct BeginScan {};
struct EndScan {};

/// Why an exploration ended.
enum class FinishReason : std::uint8_t {
  kStopLimit,    ///< as many stops as were asked for
  kNoNewGround,  ///< the last stops showed no floor that was not known
  kNowhereToGo,  ///< nothing within reach: walls all around, or no echo at all
  kCannotSense,  ///< none of a stop's sweeps was carried out: the sonar or its pan drive is broken
};

/// The exploration is over; the robot stands.
struct Finished {
  FinishReason reason = FinishReason::kStopLimit;
};

/// What an explorer asks for next.
using Motion = std::variant<Turn, Drive, Sweep, BeginScan, EndScan, Finished>;

/// How the last motion ended.
enum class MotionResult : std::uint8_t {
  kReached,      ///< as asked; also said before the first motion
  kBumped,       ///< a contact stopped it short
  kHazard,       ///< a cliff, or what the profile names beside it, stopped it short
  kStalled,      ///< the wheels did not turn
  kLifted,       ///< somebody picked the robot up: the pose is void
  kTimedOut,     ///< it took too long and was stopped
  kRefused,      ///< the robot would not begin it
  kInterrupted,  ///< line or board failed under it; the pose says how far it came
};

/// Decides where to go: a snapshot in, the next motion out.
class Explorer {
 public:
  virtual ~Explorer() = default;
  /// Called when the motion before has ended, with how it ended and a snapshot from after it. Once
  /// it has answered Finished it is not called again.
  virtual Motion next(const pipeline::Snapshot& snapshot, MotionResult last) = 0;
};

/// "stop-limit", "no-new-ground", "nowhere-to-go" or "cannot-sense".
const char* name_of(FinishReason reason);

}  // namespace echomap::exploration
