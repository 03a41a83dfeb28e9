// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {

/// The sixteen bundled rooms that maps are judged by, of 3 to 100 square metres.
const std::vector<std::string>& truth_room_names();

/// How the robot of a room is simulated.
struct TruthEmulators {
  std::string emulator = "mixed";  ///< Or "simavr" or "mock" in all of them.
  /// Where mixed is the release image.
  std::vector<std::string> simavr_rooms{"living_room", "office", "pillar_hall", "studio"};

  std::string of(const std::string& room) const;
};

/// A bundled room or that of a TOML file, in which a strategy chooses its stops. Throws
/// files::ConfigError.
TruthRoom truth_room(const std::string& world, const TruthEmulators& emulators);

/// Calls `task(i)` for i from 0 to `count` - 1, `jobs` of them at a time, in threads of their own.
void for_each_in_jobs(std::size_t count, int jobs, const std::function<void(std::size_t)>& task);

}  // namespace echomap::bench
