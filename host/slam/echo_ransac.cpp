// SPDX-License-Identifier: MIT
#include "host/slam/echo_ransac.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/optimization/normal_equations.hpp"

namespace echomap::slam {

namespace {

constexpr int kFitRounds = 4;

using geometry::square;
using mapping::Echo;
using mapping::EchoFeature;
using models::LandmarkKind;

/// Where along a wall echoes are from, in that order, and which.
using Places = std::vector<std::pair<double, std::size_t>>;

/// The first and behind the last of the most places without a wider gap.
std::pair<std::size_t, std::size_t> longest_run(const Places& places, double max_gap_m) {
  std::pair<std::size_t, std::size_t> longest{0, 0};
  for (std::size_t from = 0, to = 1; to <= places.size(); ++to) {
    if (to == places.size() || places[to].first - places[to - 1].first > max_gap_m) {
      if (to - from > longest.second - longest.first) {
        longest = {from, to};
      }
      from = to;
    }
  }
  return longest;
}

/// How echoes that are still free speak of a feature.
struct Consensus {
  std::vector<std::size_t> agreeing;
  std::size_t denying = 0;  ///< Should have heard it, and heard something behind it.

  std::size_t votes() const { return agreeing.size() - std::min(agreeing.size(), denying); }
};

class FeatureSearch {
 public:
  FeatureSearch(const std::vector<Echo>& echoes,
                const EchoRansacParams& params,
                std::mt19937& random)
      : echoes_(echoes), params_(params), is_free_(echoes.size(), true) {
    if (echoes.size() >= 2) {
      draw(random);
    }
  }

  /// The feature with the most votes, which takes its echoes. Empty where none is left.
  std::optional<HeardFeature> next() {
    while (const auto best = most_voted()) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      auto heard = fitted(candidates_[*best].feature);
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(*best));
      if (heard && is_well_known(*heard)) {
        take(heard->echoes);
        return heard;
      }
    }
    return std::nullopt;
  }

 private:
  struct Candidate {
    EchoFeature feature;
    Consensus consensus;
  };

  void draw(std::mt19937& random) {
    std::uniform_int_distribution<std::size_t> any(0, echoes_.size() - 1);
    for (std::size_t i = 0; i < params_.pairs; ++i) {
      const Echo& first = echoes_[any(random)];
      const Echo& second = echoes_[any(random)];
      if ((first.middle_m() - second.middle_m()).norm() > params_.pair_reach_m) {
        continue;
      }
      for (const EchoFeature& feature : features_through(first, second, params_.hearing)) {
        add(feature);
      }
    }
  }

  void add(const EchoFeature& feature) {
    Consensus consensus = consensus_on(feature);
    if (is_enough(consensus.votes(), feature)) {
      candidates_.push_back({feature, std::move(consensus)});
    }
  }

  bool is_enough(std::size_t votes, const EchoFeature& feature) const {
    return votes >= (feature.kind == LandmarkKind::kWall ? params_.min_wall_echoes
                                                         : params_.min_point_echoes);
  }

  std::optional<std::size_t> most_voted() const {
    std::optional<std::size_t> best;
    std::size_t most = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (candidates_[i].consensus.votes() > most) {
        most = candidates_[i].consensus.votes();
        best = i;
      }
    }
    return best;
  }

  void take(const std::vector<std::size_t>& taken) {
    for (const std::size_t i : taken) {
      is_free_[i] = false;
    }
    for (Candidate& candidate : candidates_) {
      candidate.consensus = consensus_on(candidate.feature);
    }
    std::erase_if(candidates_, [&](const Candidate& candidate) {
      return !is_enough(candidate.consensus.votes(), candidate.feature);
    });
  }

  Consensus consensus_on(const EchoFeature& feature) const {
    Consensus consensus;
    std::vector<std::size_t> denying;
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      if (!is_free_[i]) {
        continue;
      }
      const auto expected = echo_of(feature, echoes_[i], params_.hearing.max_incidence_rad);
      if (!expected) {
        continue;
      }
      const double off_m = echoes_[i].range_m - expected->range_m;
      if (std::abs(off_m) <= params_.hearing.tolerance_m) {
        consensus.agreeing.push_back(i);
      } else if (off_m > 0.0 && should_hear(feature, echoes_[i])) {
        denying.push_back(i);
      }
    }
    if (feature.kind == LandmarkKind::kWall) {
      keep_longest_piece(feature, consensus, denying);
    }
    consensus.denying = denying.size();
    return consensus;
  }

  /// A smooth wall answers where its perpendicular is in the beam.
  bool should_hear(const EchoFeature& feature, const Echo& echo) const {
    return feature.kind == LandmarkKind::kPoint || echo_of(feature, echo, 0.0).has_value();
  }

  /// The piece of the wall, without gaps, that the most echoes are of; who denies another piece
  /// does not count.
  void keep_longest_piece(const EchoFeature& wall,
                          Consensus& consensus,
                          std::vector<std::size_t>& denying) const {
    Places places;
    for (const std::size_t i : consensus.agreeing) {
      places.emplace_back(along_m(wall, echoes_[i]), i);
    }
    std::sort(places.begin(), places.end());
    const auto [from, to] = longest_run(places, params_.max_gap_m);
    consensus.agreeing.clear();
    for (std::size_t i = from; i < to; ++i) {
      consensus.agreeing.push_back(places[i].second);
    }
    const bool is_none = from == to;
    const double from_m = is_none ? 0.0 : places[from].first;
    const double to_m = is_none ? 0.0 : places[to - 1].first;
    std::erase_if(denying, [&](std::size_t i) {
      const double at_m = along_m(wall, echoes_[i]);
      return is_none || at_m < from_m || at_m > to_m;
    });
  }

  /// Of its range, and of its bearing, which is as good as evenly spread over where it is heard.
  void add_evidence(const Echo& echo,
                    const EchoFeature& feature,
                    optimization::NormalEquations<2>& equations) const {
    const auto expected = echo_of(feature, echo, params_.hearing.max_incidence_rad);
    if (!expected) {
      return;
    }
    equations.add(expected->range_m - echo.range_m,
                  expected->jacobian.row(0),
                  1.0 / square(params_.range_stddev_m));
    equations.add(geometry::angle_between(echo.axis_rad, expected->bearing_rad),
                  expected->jacobian.row(1),
                  3.0 / square(expected->max_off_axis_rad));
  }

  /// Gauss and Newton over those that agree.
  std::optional<HeardFeature> fitted(const EchoFeature& candidate) const {
    HeardFeature heard{candidate, {}, {}};
    for (int round = 0; round < kFitRounds; ++round) {
      heard.echoes = consensus_on(heard.feature).agreeing;
      if (!is_enough(heard.echoes.size(), heard.feature)) {
        return std::nullopt;
      }
      optimization::NormalEquations<2> equations;
      for (const std::size_t i : heard.echoes) {
        add_evidence(echoes_[i], heard.feature, equations);
      }
      const auto step = equations.solve();
      heard.covariance = equations.information().inverse();
      if (!step || !heard.covariance.allFinite()) {
        return std::nullopt;
      }
      heard.feature.value += *step;
    }
    if (heard.feature.kind == LandmarkKind::kWall) {
      heard.feature.value.y() = geometry::wrap_angle(heard.feature.value.y());
    }
    return heard;
  }

  bool is_well_known(const HeardFeature& heard) const {
    if (heard.feature.kind == LandmarkKind::kWall) {
      return std::sqrt(heard.covariance(1, 1)) <= params_.max_normal_stddev_rad;
    }
    return std::sqrt(heard.covariance.trace()) <= params_.max_point_stddev_m;
  }

  const std::vector<Echo>& echoes_;
  const EchoRansacParams& params_;
  std::vector<bool> is_free_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void validate(const EchoRansacParams& params) {
  geometry::ParameterValidator("echo ransac")
      .positive_finite("pair_reach_m", params.pair_reach_m)
      .positive_finite("hearing.tolerance_m", params.hearing.tolerance_m)
      .positive_finite("range_stddev_m", params.range_stddev_m)
      .positive_finite("max_gap_m", params.max_gap_m)
      .positive_finite("max_normal_stddev_rad", params.max_normal_stddev_rad)
      .positive_finite("max_point_stddev_m", params.max_point_stddev_m)
      .at_least("min_wall_echoes", params.min_wall_echoes, 3)
      .at_least("min_point_echoes", params.min_point_echoes, 3)
      .at_least("hearing.max_incidence_rad", params.hearing.max_incidence_rad, 0.0);
}

std::vector<HeardFeature> find_features(const std::vector<Echo>& echoes,
                                        const EchoRansacParams& params,
                                        std::mt19937& random) {
  FeatureSearch search(echoes, params, random);
  std::vector<HeardFeature> features;
  while (auto heard = search.next()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    features.push_back(std::move(*heard));
  }
  return features;
}

}  // namespace echomap::slam
