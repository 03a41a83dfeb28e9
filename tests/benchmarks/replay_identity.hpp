// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace echomap::bench {

/// A drive of a simulated robot in lockstep, by the programs that a user has.
struct LiveRun {
  std::string room;
  std::uint32_t seed = 1;
  /// As `echomap demo --part-faults` takes it; empty: none.
  std::string part_faults{};
  /// As `echomap-mock --kidnap` takes it; empty: the robot is not carried off.
  std::string kidnap{};
  /// As `echomap demo --emulator` takes it; a robot that is carried off is always the mock.
  std::string emulator = "mock";
};

/// The demo's room with the seeds 1 to `seeds`, five other rooms, a run with a reset of the board
/// and one in which the robot is carried off.
std::vector<LiveRun> live_runs(std::uint32_t seeds, const std::string& emulator);

/// Runs one, replays its run directory, and names the files of map.pgm, points.csv and
/// trajectory.tum that the replay wrote otherwise, byte for byte, or not at all; "the run" or "the
/// replay" where that program failed. Empty where live and replay are the same.
std::vector<std::string> differences_of_replay(const LiveRun& run);

}  // namespace echomap::bench
