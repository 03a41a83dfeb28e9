// SPDX-License-Identifier: MIT
#include "host/source_search/information_gain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/source_search/pair_kernel.hpp"

namespace echomap::source_search {

namespace {

constexpr std::size_t kRowMultiple = 16;

/// Whether one claim holds for both.
bool are_similar(const SourceHypothesis& one, const SourceHypothesis& other, double radius_m) {
  if (!one.at_m || !other.at_m) {
    return one.at_m.has_value() == other.at_m.has_value();
  }
  return (*one.at_m - *other.at_m).norm() <= radius_m;
}

}  // namespace

InformationGain::InformationGain(const SourceBelief& belief, std::vector<SourceHypothesis> samples)
    : padded_((samples.size() + kRowMultiple - 1) / kRowMultiple * kRowMultiple),
      belief_(belief),
      samples_(std::move(samples)),
      weights_(padded_, 0.0F),
      similar_(padded_ * padded_, 0.0F) {
  for (std::size_t i = 0; i < size(); ++i) {
    weights_[i] = static_cast<float>(samples_[i].probability);
    for (std::size_t j = 0; j < size(); ++j) {
      if (are_similar(samples_[i], samples_[j], belief_.params().found_radius_m)) {
        similar_[i * padded_ + j] = static_cast<float>(samples_[j].probability);
      }
    }
  }
}

/// The background is that of all hypotheses: it is no hint of where the source is.
void InformationGain::add(const PlannedDwell& dwell, PairDistances& distances) const {
  const FieldParams& field = belief_.grid().params().field;
  const double background = belief_.estimate().background.median;
  const FieldReading reading{dwell.at_m, 0.0, dwell.dwell_s, 0.0};
  const bool counts = field.kind == SensorKind::kPulses;
  std::vector<float> features(padded_, 0.0F);
  for (std::size_t i = 0; i < size(); ++i) {
    const SourceHypothesis& sample = samples_[i];
    const double source =
        sample.at_m
            ? sample.strength *
                  belief_.grid()
                      .response_at(reading, *sample.at_m, sample.edge_m, sample.attenuation_per_m)
                      .response
            : 0.0;
    features[i] = static_cast<float>(counts ? std::sqrt(background + source)
                                            : 0.5 * source / field.level_stddev);
  }
  const auto dwell_s = static_cast<float>(dwell.dwell_s);
  for (std::size_t i = 0; i < size(); ++i) {
    add_pair_distances(features.data(), padded_, features[i], dwell_s, &distances[i * padded_]);
  }
}

double InformationGain::expected_log_probability(const PairDistances& distances) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const PairSums sums =
        sum_pairs(&distances[i * padded_], &similar_[i * padded_], weights_.data(), padded_);
    sum +=
        static_cast<double>(weights_[i]) * std::log(static_cast<double>(sums.similar / sums.all));
  }
  return sum;
}

}  // namespace echomap::source_search
