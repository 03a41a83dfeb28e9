// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace echomap::tests {

/// What one hears who joins a fleet late.
struct LateJoin {
  std::uint64_t dropped = 0;  ///< Of what was published, by the client itself.
  std::size_t objects = 0;    ///< Different retained ones that have come within a minute.
  bool are_retained = true;   ///< All that came were.
  double seconds = 0.0;       ///< From its connection to the last of them.
};

/// Retains so many objects of 500 bytes on a broker as `fleet start` sets it up; then another robot
/// subscribes to all.
LateJoin join_late(std::size_t objects);

}  // namespace echomap::tests
