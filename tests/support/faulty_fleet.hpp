// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace echomap::tests {

/// What became of four robots on a Mosquitto that was killed, behind a proxy that delayed, stalled
/// and cut at times drawn by the seed.
struct FaultyFleetRun {
  /// All that lived had the same objects and the same graphs within 300 s of their clock.
  bool is_same = false;
  std::size_t late_objects = 0;  ///< What the one has that came in the place of a killed one.
  double bytes_per_s = 0.0;      ///< That the first robot sent in the mean, of its clock.
};

/// Of the four that made as many each, the three that lived to the end.
constexpr std::size_t kMinFaultyFleetObjects = 12;
constexpr std::size_t kMaxFaultyFleetObjects = 16;

/// Runs such a fleet over a real broker, ten times as fast as its clock says: half a minute.
FaultyFleetRun run_faulty_fleet(std::uint32_t seed);

}  // namespace echomap::tests
