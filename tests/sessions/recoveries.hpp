// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace echomap::tests {

/// What breaks the link of a robot that drives.
enum class Break : std::uint8_t {
  kUnplugged,      ///< The cable is out for a while; the board goes on.
  kReplugged,      ///< The same, and opening the port resets the board into its boot loader.
  kResetPin,       ///< Reset, and the boot loader's silence.
  kWatchdogReset,  ///< The program hangs until the watchdog resets it.
};

/// What came of so many of them.
struct Recoveries {
  int breaks = 0;
  int recovered = 0;              ///< The host carried out the next motion, with nobody's help.
  double longest_s = 0.0;         ///< From the break's end until the link was ready again.
  double worst_position_m = 0.0;  ///< What a break has added to the error of the pose.
};

/// Breaks the link of the host's session to the release image `elf`, again and again, in the middle
/// of drives to and fro: each time at another moment and for another while.
Recoveries measure_recoveries(const std::filesystem::path& elf,
                              Break kind,
                              int breaks,
                              std::uint32_t seed = 1);

}  // namespace echomap::tests
