// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/intent.hpp"
#include "host/mapping/cell_field.hpp"
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

/// Both wheels at a steady speed for a while: an arc, or a turn on the spot where `forward_m_per_s`
/// is 0. The wheels roll on into a next motion that is a Roll, too; before any other they stop.
struct Roll {
  double forward_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;  ///< Counter-clockwise positive.
  double for_s = 0.0;
};

/// Pan the sonar from `from_rad` to `to_rad`, both read, in steps, and wait after each.
struct Sweep {
  double from_rad = 0.0;
  double to_rad = 0.0;
  double step_rad = 0.0;
  double settle_s = 0.0;
};

/// Stand still for so long.
struct Stand {
  double for_s = 0.0;
};

/// The readings between these two are one scan (RobotPipeline::begin_scan, end_scan).
struct BeginScan {};
struct EndScan {};

/// The robot is somewhere else than its map: sets that map aside, without so many of its last
/// stops, and begins another one (RobotAtlas::begin_new_map). Ends with kReached.
struct BeginNewMap {
  std::size_t stops_elsewhere = 0;
};

/// Looks for the map in those that were set aside (RobotAtlas::join). Ends with kReached where it
/// was joined to one, else with kRefused.
struct JoinMaps {};

/// Why an exploration ended.
enum class FinishReason : std::uint8_t {
  kComplete,     ///< the strategy has done what it set out to do
  kStopLimit,    ///< as many stops as were asked for
  kNoNewGround,  ///< the last stops showed no floor that was not known
  kNowhereToGo,  ///< nothing within reach: walls all around, or no echo at all
  kCannotSense,  ///< none of a stop's sweeps was carried out: the sonar or its pan drive is broken
  kWaypointsMissed,  ///< at the last waypoint, and without some of those before it
  kNotBack,          ///< the last waypoint was out of reach
  kStuck,            ///< the robot is held, or its wheels turn and it does not move
  kLifted,           ///< somebody has picked it up: the pose is void
  kBatteryLow,       ///< short of power; it has gone back to where it started, if it could
  kSonarSilent,      ///< the sonar did not answer its triggers
  kSonarStuck,       ///< the sonar says one range, wherever it looks
  kWheelFault,       ///< a wheel does not turn, or its encoder does not count
  kLost,  ///< what it hears is not what the map has there: carried off, or its wheels slipped
};

/// The exploration is over; the robot stands.
struct Finished {
  FinishReason reason = FinishReason::kStopLimit;
  /// Of a robot that is lost: so many of its last stops are of another place than its map.
  std::size_t stops_elsewhere = 0;
};

/// What an explorer asks for next: a motion of the robot, or a decision about its maps.
using Motion = std::
    variant<Turn, Drive, Roll, Sweep, Stand, BeginScan, EndScan, BeginNewMap, JoinMaps, Finished>;

/// Result of the last motion.
enum class MotionResult : std::uint8_t {
  kReached,      ///< as asked; also said before the first motion
  kBumped,       ///< a contact stopped it short
  kHazard,       ///< a cliff, or what the profile names beside it, stopped it short
  kStalled,      ///< the wheels did not turn
  kLifted,       ///< somebody picked the robot up: the pose is void
  kTimedOut,     ///< it took too long and was stopped
  kRefused,      ///< the robot would not begin it
  kInterrupted,  ///< line or board failed under it; the pose says how far it came
  kTakenOver,    ///< a person has had the robot meanwhile, which may stand anywhere
};

/// What a strategy has made of its own, beside the map that the pipeline makes.
struct StrategyProducts {
  /// Outline of the room in the map frame, counter-clockwise; empty for none.
  std::vector<Eigen::Vector2d> outline_m;
  /// Confidence that there is an obstacle, cell by cell; null for none.
  std::shared_ptr<const mapping::CellField> confidence;
  /// Waypoints that it had, and those that it has reached; 0 where it has none.
  std::size_t phases = 0;
  std::size_t phases_reached = 0;
};

/// Decides where to go: a snapshot in, the next motion out.
class Explorer {
 public:
  virtual ~Explorer() = default;
  /// Called when the motion before has ended, with how it ended and a snapshot from after it. Once
  /// it has answered Finished it is not called again.
  virtual Motion next(const pipeline::Snapshot& snapshot, MotionResult last) = 0;
  /// What it has made so far.
  virtual StrategyProducts products() const { return {}; }
  /// What it is about.
  virtual Intent intent() const { return {}; }
};

/// As summary.json says it: "complete", "stop-limit", ...
const char* name_of(FinishReason reason);

}  // namespace echomap::exploration
