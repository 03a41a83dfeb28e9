// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/source_search/source_belief.hpp"

namespace echomap::source_search {

/// A reading that is still to be taken.
struct PlannedDwell {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double dwell_s = 0.0;
};

/// How well readings discriminate between hypotheses: for each pair the Bhattacharyya distance of
/// what they would read, which adds up over readings; for Poisson numbers half the squared
/// difference of the roots of their means.
using PairDistances = std::vector<float>;

/// Information about the source's place that readings at planned places are expected to give: the
/// expected rise of the log-probability of the true hypothesis. Places within the radius in which a
/// source counts as found are one hypothesis, and no source is one. By samples of the posterior,
/// with the bound of Kolchinsky and Tracey 2017 in place of the expectation over the readings.
class InformationGain {
 public:
  InformationGain(const SourceBelief& belief, std::vector<SourceHypothesis> samples);

  std::size_t size() const { return samples_.size(); }
  /// Distances without any reading: all hypotheses are one.
  PairDistances no_reading() const { return PairDistances(padded_ * padded_, 0.0F); }
  /// Adds a reading.
  void add(const PlannedDwell& dwell, PairDistances& distances) const;
  /// The expected logarithm of the probability of what is true, in nats; at most 0.
  double expected_log_probability(const PairDistances& distances) const;

 private:
  /// Time for which has been read there, seconds.
  double read_s(const Eigen::Vector2d& at_m) const;

  std::size_t padded_;  ///< Hypotheses in a row of a matrix; those beyond `size` have no weight.
  const SourceBelief& belief_;
  std::vector<SourceHypothesis> samples_;
  std::vector<float> weights_;
  std::vector<float> similar_;  ///< By pair: the weight of the second where both are one claim.
};

}  // namespace echomap::source_search
