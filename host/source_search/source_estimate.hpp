// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace echomap::source_search {

/// What the readings say about a source.
enum class SourceVerdict : std::uint8_t {
  kUndecided,
  kFound,  ///< It is within the radius of the best place, with the probability that was asked for.
  kNone,   ///< There is none as strong as the weakest that counts, with that probability.
};

/// A value and how well it is known; of logarithms, so that the error is a factor.
struct LogEstimate {
  double median = 0.0;
  double log_stddev = 0.0;
};

/// What is known about the source.
struct SourceEstimate {
  SourceVerdict verdict = SourceVerdict::kUndecided;
  /// That there is no source as strong as the weakest that counts.
  double none_probability = 1.0;
  /// That the source is on floor that the map has not, too far from it to be read.
  double unseen_probability = 0.0;
  /// The middle of the disc that most probably holds the source, in the map frame.
  Eigen::Vector2d best_m = Eigen::Vector2d::Zero();
  /// That the source is there and in that disc.
  double within_probability = 0.0;
  /// That is as probable as a claim has to be, but was not confirmed from beside.
  bool is_to_confirm = false;
  /// The disc around `best_m` that holds the source with 95 %, if there is one.
  double radius_95_m = 0.0;
  LogEstimate strength;  ///< Of a source at `best_m`, one metre away.
  LogEstimate background;
};

/// "undecided", "found" or "none".
const char* name_of(SourceVerdict verdict);

}  // namespace echomap::source_search
