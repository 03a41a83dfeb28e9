// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::bench {

/// Which fleets are started: `echomap fleet start --robots N --world W --headless --seed S`.
struct TeamRuns {
  std::vector<std::string> worlds{"office", "corridor_rooms", "ward"};
  std::vector<std::size_t> robots{2, 4};
  int first_seed = 1;
  int last_seed = 40;
  std::string emulator = "simavr";
  /// As `fleet start` takes it: empty for its own, where the first robot begins at the world's
  /// start, or "drawn" for all of them.
  std::string starts = "drawn";
  int jobs = 1;                     ///< Fleets at a time.
  int patience_min = 45;            ///< Minutes by the wall after which one has not ended.
  std::filesystem::path folder{};   ///< Of all runs; one that is there is not made again.
  std::filesystem::path program{};  ///< Empty: the echomap beside this program.
};

/// A fleet, as it is told from others.
struct TeamCase {
  std::string world;
  std::size_t robots = 1;
  int seed = 1;
};

/// What one came to; what there is no value of was not told, since it did not come so far.
struct TeamRun {
  TeamCase what;
  /// Exit code of `fleet start`, 128 + signal where one ended it; empty where time ran out.
  std::optional<int> exit;
  std::string outcome;               ///< Empty where it wrote no summary.
  std::vector<std::string> endings;  ///< Of each robot: its name, exit code and outcome.
  std::optional<double> joined_s;
  /// How far the farthest map is placed off beyond what two maps are off by themselves, metres:
  /// the error of the relative pose less the ATE of both.
  std::optional<double> beyond_own_m;
  std::optional<double> pose_error_m;
  std::optional<double> heading_error_rad;
  std::size_t wrong_joins = 0;
  std::size_t wrong_joins_left = 0;
  std::optional<double> free_iou;
  std::optional<double> solid_called_free;
  double floor_seen = 0.0;
  std::optional<double> floor_90_s;
  double sim_seconds = 0.0;
  int bumps = 0;            ///< Hulls that met anything, of all robots.
  int hard_collisions = 0;  ///< Those at speed, or where no bumper is.
  std::size_t deadlocks = 0;
  std::size_t deadlocks_left = 0;
  std::optional<double> kbytes_per_s_per_robot;
  double wall_s = 0.0;
  double cpu_s = 0.0;
  std::vector<geometry::Pose2> T_world_starts;

  /// All maps were one at the end, and no wrong one among them.
  bool is_joined() const { return joined_s.has_value() && wrong_joins_left == 0; }
  /// It ended by itself with all that was asked for.
  bool is_complete() const { return exit == 0; }
};

/// A fleet beside one robot that began where its first one did.
struct TeamPair {
  TeamRun team;
  TeamRun alone;
  /// The same ratio of times of an ideal team; empty in a world that is too large to ask for it.
  std::optional<double> ideal_ratio;

  /// Time of the team to nine tenths of the floor by that of the one; infinite for a team that
  /// never had them, empty where the one did not.
  std::optional<double> time_ratio() const;
};

/// Reads what such a run has left in its folder: `what` says which one it was.
TeamRun read_team_run(const TeamCase& what, const std::filesystem::path& folder);

/// Makes the runs that are not there yet, a team before its single robot, and reads all of them, by
/// seed, world and number of robots. A run that could not be made is one that did not end. Says
/// each on stderr as it ends.
std::vector<TeamPair> run_teams(const TeamRuns& runs);

}  // namespace echomap::bench
