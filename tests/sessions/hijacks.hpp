// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace echomap::tests {

/// What came of a second program's tries to get a robot that drives.
struct Hijacks {
  int tries = 0;
  int refused = 0;  ///< The drive went on to its end, on a link that was ready all the time.
};

/// Says Hello in another session's name while the release image `elf` drives for
/// the host's session: each time in the middle of another drive, at another moment.
Hijacks measure_hijacks(const std::filesystem::path& elf, int tries, std::uint32_t seed = 1);

}  // namespace echomap::tests
