// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/evaluation/own_map_pose.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {

/// What a robot that was carried off told at a stop.
struct ToldPlace {
  bool is_localized = false;
  double lost_probability = 1.0;
  /// Of the place that it told, in its own map; empty where it told none.
  std::optional<evaluation::PlaceError> error;

  /// It says that it is there and nowhere else, with a probability of 0.95 or more.
  bool is_claim() const;
  bool is_right() const { return error && error->is_right(); }
};

/// A robot that explored a room and was carried off in the map that it made.
struct CarriedRun {
  std::string room;
  std::optional<double> symmetry_rad;  ///< Of the room; empty where it looks alike by no turn.
  int seed = 0;
  std::string why_not;          ///< It was not carried off; empty where it was.
  std::string ended;            ///< "localized", "ambiguous" or "not localized".
  std::vector<ToldPlace> told;  ///< At each stop since.

  bool has_run() const { return why_not.empty(); }
  /// Its last stop is localized and there.
  bool is_found() const;
  /// It never claimed a wrong place, and ended ambiguous or is found.
  bool is_told_ambiguous() const;
};

/// The run with what its report.json says of it; `why_not` says what is missing. Throws what the
/// JSON throws.
CarriedRun read_carried(CarriedRun run, const std::string& report_json);

/// Drives one seed. Files are in `folder`, an empty one. Says on stderr what became of it.
CarriedRun carry_off(const TruthRoom& room,
                     const TruthRobot& robot,
                     int seed,
                     const std::filesystem::path& folder);

/// own_map_found: share of the runs in rooms without symmetry that are found; ambiguous_told: share
/// of those in the others that are told as such; wrong_claims: share of all claims that are wrong;
/// reliability_gap: of the told probabilities of being lost, over all stops; carried_not_run: how
/// many were not carried off, which count nowhere else. A share of nothing is no figure.
std::vector<Figure> carried_figures(const std::vector<CarriedRun>& runs);

/// A row for each room, in the order of their runs.
MarkdownTable carried_table(const std::vector<CarriedRun>& runs);

}  // namespace echomap::bench
