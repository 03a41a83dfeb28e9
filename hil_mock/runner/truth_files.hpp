// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "hil_mock/runner/lockstep_run.hpp"
#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// What truth.json says beside what the simulation knows.
struct TruthSummary {
  std::uint32_t seed = 0;
  /// Bytes of the device that nobody has read.
  std::uint64_t dropped_bytes = 0;
  /// Only where a lockstep host has vanished.
  std::optional<StopReport> stop;
};

/// Writes truth.tum, truth_map.pgm, truth_map.yaml, truth_walls.geojson and truth.json into
/// `directory` (docs/guides/truth_files.md); each is whole or not there. Throws files::FileError.
void write_truth_files(const std::filesystem::path& directory,
                       const RobotSimulation& simulation,
                       const TruthSummary& summary);

/// One line for a person: when the wheels stopped, in seconds and in CPU cycles of the Uno.
std::string describe(const StopReport& report);

}  // namespace echomap::runner
