// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/source_search/source_search.hpp"
#include "tests/support/source_world.hpp"

namespace echomap::tests {

/// How a source is searched offline, by robots whose poses and maps are right.
struct OfflineSearch {
  source_search::SourceSearchParams params;
  /// One robot each. All of them have all readings.
  std::vector<geometry::Pose2> starts;
  std::uint32_t seed = 1;
  /// A reading lasts so long at most, and leads no farther than this.
  double reading_s = 1.0;
  double reading_m = 0.2;
  double turn_rad_per_s = 2.0;
  double max_s = 3000.0;
};

/// How it ended: with the first robot that was sure.
struct OfflineSearchRun {
  double time_s = 0.0;
  double driven_m = 0.0;  ///< Of all robots.
  std::size_t readings = 0;
  source_search::SourceEstimate estimate;
  double error_m = 0.0;   ///< Of the best place, where there is a source.
  bool is_right = false;  ///< A claim of a place within the radius, or of none where there is none.

  bool is_claim() const { return estimate.verdict != source_search::SourceVerdict::kUndecided; }
};

/// Carries out what each robot's SourceSearch asks for, ideally, on the robots' own clocks.
OfflineSearchRun search_offline(const SourceWorld& world,
                                const SourceTruth& truth,
                                const OfflineSearch& search);

/// Places of so many robots, `apart_m` apart or more.
std::vector<geometry::Pose2> sample_starts(const SourceWorld& world,
                                           std::size_t robots,
                                           double apart_m,
                                           std::mt19937& random);

}  // namespace echomap::tests
