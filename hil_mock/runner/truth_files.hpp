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

/// Writes into `directory` what is true so far, each file whole or not at all, in the world frame:
/// truth.tum (`t x y z qx qy qz qw` in simulated seconds and metres, 50 Hz), truth_map.pgm and
/// truth_map.yaml (ROS map_server, cells of 1 cm) and truth_walls.geojson (a LineString for each
/// wall, metres); and source.json, what radiates, where the robot can sense it or something does.
/// Throws files::FileError.
void write_truth_so_far(const std::filesystem::path& directory, const RobotSimulation& simulation);

/// The same at the end, and truth.json: what ran.
void write_truth_files(const std::filesystem::path& directory,
                       const RobotSimulation& simulation,
                       const TruthSummary& summary);

/// One line for a person: when the wheels stopped, in seconds and in CPU cycles of the Uno.
std::string describe(const StopReport& report);

}  // namespace echomap::runner
