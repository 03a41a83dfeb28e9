// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "tests/benchmarks/fleet_load.hpp"

namespace echomap::bench {

/// What robots of a fleet published, by an MCAP file of `echomap fleet record`: kinds and sizes as
/// they were, each at the time on its robot's clock that its latest pose before has. The rounds of
/// a simulated fleet are left out: robots that are not simulated have none. Throws
/// files::FileError, also for a file without a pose.
LoadRecord read_fleet_record(const std::filesystem::path& mcap);

/// Records two simulated robots in a small room to `folder`/fleet.mcap, as a user would: `echomap
/// fleet start` and, beside it, `fleet record`. Answers the file. Throws std::runtime_error where
/// either does not end well.
std::filesystem::path record_a_fleet(const std::filesystem::path& folder);

}  // namespace echomap::bench
