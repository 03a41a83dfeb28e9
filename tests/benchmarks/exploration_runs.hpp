// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/exploration_case.hpp"

namespace echomap::bench {

using tests::ExplorationCase;

/// tests/benchmarks/exploration_log.
class ExplorationLog;

/// Which seeds are run, and how many of them at a time: a run is a function of its seed alone.
struct SeedRange {
  int first = 1;
  int count = 20;
  int jobs = 2;
};

/// What a run came to.
struct ExplorationRun {
  /// The strategy said by itself that it was done.
  bool complete = false;
  std::string outcome;
  double free_iou = 0.0;
  std::optional<double> wall_rmse_m;
  double wall_recall = 0.0;
  double sim_seconds = 0.0;
  double distance_m = 0.0;
  int bumps = 0;
  int hard_collisions = 0;
  std::size_t corners = 0;       ///< Of the outline.
  std::size_t room_corners = 0;  ///< Of the room's floor.
  std::optional<double> corner_rmse_m;
  /// Places of a course, and how many of them were reached.
  std::optional<std::size_t> phases;
  std::optional<std::size_t> phases_reached;
  /// How far from where it started the robot truly was at the end, and at most.
  double end_off_start_m = 0.0;
  double max_distance_from_start_m = 0.0;
};

/// The runs of a case, in the order of their seeds. Those that did not end by themselves or whose
/// map has no score are left out, with what the program said on stderr. Those that the log has are
/// taken from there, and the others are added.
std::vector<ExplorationRun> explore_seeds(const ExplorationCase& what,
                                          const SeedRange& seeds,
                                          ExplorationLog& log);

}  // namespace echomap::bench
