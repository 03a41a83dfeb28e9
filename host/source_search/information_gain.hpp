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

/// How far readings tell hypotheses apart: for each pair the Bhattacharyya distance of what they
/// would read, which adds up over readings; of Poisson numbers half the squared difference of the
/// roots of their means.
using PairDistances = std::vector<float>;

/// What readings at planned places are expected to tell about where the source is: by how much the
/// logarithm of the probability of what is true is expected to rise, of places within the radius in
/// which a source counts as found and of no source as one. By samples of the posterior, with the
/// bound of Kolchinsky and Tracey 2017 in place of the expectation over what is read.
class InformationGain {
 public:
  InformationGain(const SourceBelief& belief, std::vector<SourceHypothesis> samples);

  std::size_t size() const { return samples_.size(); }
  /// Without any reading: all hypotheses are one.
  PairDistances no_reading() const { return PairDistances(padded_ * padded_, 0.0F); }
  /// Adds a reading.
  void add(const PlannedDwell& dwell, PairDistances& distances) const;
  /// The expected logarithm of the probability of what is true, in nats; at most 0.
  double expected_log_probability(const PairDistances& distances) const;

 private:
  /// For how long has been read there.
  double read_s(const Eigen::Vector2d& at_m) const;

  std::size_t padded_;  ///< Hypotheses in a row of a matrix; those beyond `size` have no weight.
  const SourceBelief& belief_;
  std::vector<SourceHypothesis> samples_;
  std::vector<float> weights_;
  std::vector<float> similar_;  ///< By pair: the weight of the second where both are one claim.
};

}  // namespace echomap::source_search
