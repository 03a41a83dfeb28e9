// SPDX-License-Identifier: MIT
#include "host/source_search/information_gain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/square.hpp"
#include "host/source_search/pair_kernel.hpp"

namespace echomap::source_search {

using geometry::square;

namespace {

constexpr std::size_t kRowMultiple = 16;

/// Whether one claim holds for both.
bool are_similar(const SourceHypothesis& one, const SourceHypothesis& other, double radius_m) {
  if (!one.at_m || !other.at_m) {
    return one.at_m.has_value() == other.at_m.has_value();
  }
  return (*one.at_m - *other.at_m).norm() <= radius_m;
}

/// A reading so near to others has the same error of its rate.
constexpr double kSamePlaceM = 0.15;

/// Seconds of a dwell without any error of the rate that are worth as much as `dwell_s` with it: a
/// longer dwell adds less and less where the error of the rate is larger than that of the count.
double useful_s(double dwell_s, double source, double background, double excess) {
  return dwell_s / (1.0 + excess * dwell_s / (source + background));
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

double InformationGain::read_s(const Eigen::Vector2d& at_m) const {
  double read_s = 0.0;
  for (const FieldReading& reading : belief_.grid().readings()) {
    read_s += (reading.at_m - at_m).norm() < kSamePlaceM ? reading.dwell_s : 0.0;
  }
  return read_s;
}

/// The background is that of all hypotheses: it is no hint of where the source is.
void InformationGain::add(const PlannedDwell& dwell, PairDistances& distances) const {
  const HypothesisGrid& grid = belief_.grid();
  const FieldParams& field = grid.params().field;
  const double background = belief_.estimate().background.median;
  const FieldReading reading{dwell.at_m, 0.0, dwell.dwell_s, 0.0};
  const double before_s = read_s(dwell.at_m);
  std::vector<float> features(padded_, 0.0F);
  std::vector<float> useful(padded_, 0.0F);
  for (std::size_t i = 0; i < size(); ++i) {
    const SourceHypothesis& sample = samples_[i];
    HypothesisGrid::Response response;
    if (sample.at_m) {
      response = grid.response_at(reading, *sample.at_m, sample.edge_m, sample.shielding);
    }
    const double source = sample.strength * response.response;
    if (field.kind == SensorKind::kLevel) {
      features[i] = static_cast<float>(0.5 * source / field.level_stddev);
      useful[i] = static_cast<float>(dwell.dwell_s);
      continue;
    }
    const double excess =
        response.variance * square(source) + square(field.background_error * background);
    features[i] = static_cast<float>(std::sqrt(background + source));
    useful[i] = static_cast<float>(useful_s(before_s + dwell.dwell_s, source, background, excess) -
                                   useful_s(before_s, source, background, excess));
  }
  for (std::size_t i = 0; i < size(); ++i) {
    add_pair_distances(features.data(), padded_, features[i], useful[i], &distances[i * padded_]);
  }
}

double InformationGain::expected_log_probability(const PairDistances& distances) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (weights_[i] <= 0.0F) {
      continue;
    }
    const PairSums sums =
        sum_pairs(&distances[i * padded_], &similar_[i * padded_], weights_.data(), padded_);
    sum +=
        static_cast<double>(weights_[i]) * std::log(static_cast<double>(sums.similar / sums.all));
  }
  return sum;
}

}  // namespace echomap::source_search
