// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace echomap::bench {

/// A drive of a simulated robot in lockstep, by the programs that a user has.
struct LiveRun {
  std::string room = "living_room";
  std::uint32_t seed = 1;
  /// As `echomap-simavr --part-faults` takes it; empty: none.
  std::string part_faults{};
  /// As `echomap-simavr --kidnap` takes it; empty: the robot is not carried off.
  std::string kidnap{};
  std::string emulator = "simavr";  ///< Or "mock".
  int stops = 0;                    ///< At most; 0: as many as it takes.
};

/// What became of a run that was made and replayed.
struct ReplayedRun {
  /// The files of map.pgm, points.csv and trajectory.tum that the replay wrote otherwise, byte for
  /// byte, or not at all; "the run" or "the replay" where that program failed.
  std::vector<std::string> differences{};
  double robot_s = 0.0;   ///< Time of the robot in the recording.
  double replay_s = 0.0;  ///< Time that `echomap replay` took.
  double recording_mb = 0.0;
};

/// For each seed from 1 on a plain run, one with a reset of the board and one in which the robot is
/// carried off while it maps.
std::vector<LiveRun> live_runs(std::uint32_t seeds, const std::string& emulator, int stops);

/// Makes the run and replays its recording.
ReplayedRun replay(const LiveRun& run);

/// Seconds of the session that the recording of a real-time robot lacks where `echomap explore` is
/// killed after so many seconds: from its last message to the kill. Below zero where it cannot be
/// read.
double seconds_lost_by_kill(double after_s, std::uint32_t seed);

}  // namespace echomap::bench
