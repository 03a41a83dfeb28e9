// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace echomap::exports {

/// What the link to the robot carried and lost; the fields are the keys of `link` in summary.json.
struct LinkSummary {
  std::uint64_t frames_received = 0;
  std::uint64_t frames_bad = 0;   ///< Of the robot, that failed a check.
  std::uint64_t frames_lost = 0;  ///< Of the robot, bad ones included, modulo 256 in one gap.
  std::uint64_t frames_sent = 0;
  std::uint64_t commands_resent = 0;
  std::uint64_t credit_released_bytes = 0;  ///< Sent, and given up for want of an answer.
  std::optional<double> round_trip_us;      ///< Of a command; empty before the first.
  std::uint64_t resets = 0;
  /// How often the link was away, by silence or resets, and for how long in all.
  std::uint64_t outages = 0;
  double outage_seconds = 0.0;
  std::uint64_t reconnects = 0;  ///< Of the port, which was opened again.

  /// What the robot has counted of itself.
  std::uint64_t robot_frames_bad = 0;
  std::uint64_t robot_frames_lost = 0;
  std::uint64_t robot_receive_overruns = 0;
  std::uint64_t robot_telemetry_dropped = 0;
  /// Empty where the board cannot see them.
  std::optional<std::uint64_t> robot_encoder_errors = 0;
  std::optional<std::uint64_t> robot_left_encoder_errors = 0;
  std::optional<std::uint64_t> robot_right_encoder_errors = 0;
  std::optional<std::uint16_t> robot_stack_free_bytes;  ///< The least; empty where not told.
  std::uint8_t robot_rate_step = 0;
};

/// What of the floor in reach a map has, by its own estimate; the fields are the keys of `coverage`
/// in summary.json.
struct CoverageSummary {
  double share = 0.0;  ///< Of 1.
  double seen_m2 = 0.0;
  double unseen_m2 = 0.0;
  /// Places with unknown floor in reach, the largest first: x_m, y_m (map frame), area_m2.
  std::vector<std::array<double, 3>> places{};
  /// Gaps too narrow for the robot: x_m, y_m (map frame), width_m, behind_m2.
  std::vector<std::array<double, 4>> gaps{};
  /// Walls that may be doors, the widest first: the middle's x_m, y_m (map frame), width_m.
  std::vector<std::array<double, 3>> possible_doors{};
};

/// What its first stops have shown to be wrong with a robot; the fields are the keys of
/// `robot_fault` in summary.json.
struct FaultSummary {
  std::string name;       ///< name_of(FaultKind)
  double value = 0.0;     ///< By how much (diagnosis::Fault).
  double log_odds = 0.0;  ///< Against a sound robot; 0 where it was not compared with one.
  std::size_t stops = 0;  ///< After which it was found.
};

/// The value of `robot_fault` in a report; null without a fault.
nlohmann::ordered_json to_json(const std::optional<FaultSummary>& fault);

/// What a run was and how it went; the fields are the keys of summary.json.
struct RunSummary {
  std::string echomap_version;
  std::string strategy;
  /// How it ended: name_of(FinishReason), "interrupted", "link-lost", ...
  std::string outcome;
  /// Whether what was asked is there; if not, why, and in any case what to do or to type next.
  bool finished = false;
  std::string why;
  std::string next;
  /// Empty for a robot that hears nothing, and while it drives.
  std::optional<CoverageSummary> coverage;
  /// What the map's walls are expected to be off by: half of such maps are better, and nine in ten.
  /// Empty while it drives, and without multiscan SLAM.
  std::optional<double> expected_wall_rmse_m;
  std::optional<double> wall_rmse_p90_m;
  std::optional<FaultSummary> robot_fault;
  std::string robot;
  /// What placed the robot on its map: slam::NamedSlam::name, or "none" for its odometry.
  std::string slam;
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
  LinkSummary link;
  std::size_t stops = 0;
  /// Those of the run that this one has resumed, which `sim_seconds`, `stops` and all that follows
  /// hold, too; empty where it started again.
  std::optional<std::size_t> resumed_stops;
  /// Maps from which the robot was carried away and that were not found again (previous_1, ...),
  /// and those that were and are part of this one.
  std::size_t previous_maps = 0;
  std::size_t maps_joined = 0;
  /// Rows of poses.csv and of points.csv.
  std::size_t poses = 0;
  std::size_t points = 0;
  /// Whether the strategy itself drew outline.geojson; else it is that of the grid.
  bool outline_by_strategy = false;
  /// Waypoints that the strategy had, and those that it has reached; empty where it has none.
  std::optional<std::size_t> phases;
  std::optional<std::size_t> phases_reached;
  /// How well SLAM knows where the robot ended: root of the variances of x and y together, and of
  /// the heading; empty without SLAM.
  std::optional<double> pose_stddev_m;
  std::optional<double> pose_stddev_deg;
  /// Length of the trajectory, and the floor known to be free.
  double travelled_m = 0.0;
  double free_area_m2 = 0.0;
};

/// As indented JSON with a newline at the end.
std::string to_json_text(const RunSummary& summary);

/// Throws files::FileError.
void write_summary_json(const std::filesystem::path& path, const RunSummary& summary);

}  // namespace echomap::exports
