// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace echomap::exports {

/// What a run was and how it went; the fields are the keys of summary.json.
struct RunSummary {
  std::string echomap_version;
  std::string strategy;
  /// How it ended: name_of(FinishReason), "interrupted", "link-lost", ...
  std::string outcome;
  std::string robot;
  std::string world;
  std::string firmware;
  std::string emulator;
  std::uint32_t seed = 0;
  double sim_seconds = 0.0;
  double wall_seconds = 0.0;
  /// How much faster than the host's the robot's clock ran, and how well its instants are placed on
  /// the host's; empty where no ping was answered.
  std::optional<double> clock_rate_error_ppm;
  std::optional<double> clock_uncertainty_us;
  std::size_t stops = 0;
  /// Rows of poses.csv and of points.csv.
  std::size_t poses = 0;
  std::size_t points = 0;
  /// Length of the trajectory, and the floor known to be free.
  double travelled_m = 0.0;
  double free_area_m2 = 0.0;
};

/// As indented JSON with a newline at the end.
std::string to_json_text(const RunSummary& summary);

/// Throws files::FileError.
void write_summary_json(const std::filesystem::path& path, const RunSummary& summary);

}  // namespace echomap::exports
