// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace echomap::source_search {

/// Conclusion about a source from the readings.
enum class SourceVerdict : std::uint8_t {
  kUndecided,
  kFound,  ///< It is within the radius of the best place, with the required probability.
  kNone,   ///< There is none as strong as the weakest considered, with that probability.
};

/// A value and the standard deviation of its logarithm, so that the error is a factor.
struct LogEstimate {
  double median = 0.0;
  double log_stddev = 0.0;
};

/// What is known about the source.
struct SourceEstimate {
  SourceVerdict verdict = SourceVerdict::kUndecided;
  /// Probability that there is no source as strong as the weakest considered.
  double none_probability = 1.0;
  /// Probability that the source is on floor outside of the map, too far from it to be read.
  double unseen_probability = 0.0;
  /// The middle of the disc that most probably holds the source, in the map frame.
  Eigen::Vector2d best_m = Eigen::Vector2d::Zero();
  /// Probability that there is a source and that it is in that disc.
  double within_probability = 0.0;
  /// That is probable enough for a claim, but was not confirmed from beside.
  bool is_to_confirm = false;
  /// The disc around `best_m` that holds the source with 95 %, if there is one.
  double radius_95_m = 0.0;
  LogEstimate strength;  ///< Of a source at `best_m`, one metre away.
  LogEstimate background;
};

/// "undecided", "found" or "none".
const char* name_of(SourceVerdict verdict);

}  // namespace echomap::source_search
