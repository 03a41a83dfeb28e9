// SPDX-License-Identifier: MIT
#include "host/mapping/feature_finder.hpp"

#include <algorithm>
#include <limits>

namespace echomap::mapping {

FeatureFinder::FeatureFinder(std::vector<Sighting> sightings,
                             FeatureContradiction contradiction,
                             const SurfaceMatchingParams& params)
    : sightings_(std::move(sightings)),
      gate_(sightings_, params.range_tolerance_m),
      contradiction_(std::move(contradiction)),
      params_(params) {
  for (std::size_t i = 0; i < sightings_.size(); ++i) {
    for (std::size_t j = i + 1; j < sightings_.size(); ++j) {
      if (sightings_[i].scan != sightings_[j].scan) {
        propose(sightings_[i], sightings_[j]);
      }
    }
  }
}

void FeatureFinder::propose(const Sighting& first, const Sighting& second) {
  for (const EchoFeature& feature : features_through(first.circle(), second.circle())) {
    add_proposal(feature, first, second);
  }
  if ((first.echo_m - second.echo_m).norm() > params_.max_echoes_apart_m) {
    return;
  }
  for (const double radius_m : params_.radii_m) {
    for (const EchoFeature& round : circles_through(first.circle(), second.circle(), radius_m)) {
      add_proposal(round, first, second);
    }
  }
}

void FeatureFinder::add_proposal(const EchoFeature& feature,
                                 const Sighting& first,
                                 const Sighting& second) {
  const FeatureGauge gauge(feature, params_);
  if (gauge.misfit_m(first) && gauge.misfit_m(second)) {
    Proposal proposal{feature, {}, 0.0};
    gather(proposal);
    queue_.emplace(proposal.support, proposals_.size());
    proposals_.push_back(std::move(proposal));
  }
}

/// Support hardly grows as others take sightings, so a proposal that is still ahead of the stale
/// support of the next is the best.
std::optional<SupportedFeature> FeatureFinder::take_best() {
  while (!queue_.empty() && queue_.top().first >= params_.min_support) {
    const std::size_t index = queue_.top().second;
    queue_.pop();
    gather(proposals_[index]);
    const double support = proposals_[index].support;
    if (proposals_[index].supporters.size() < 2 || support < params_.min_support) {
      continue;
    }
    if (!queue_.empty() && support < queue_.top().first) {
      queue_.emplace(support, index);
      continue;
    }
    return take(proposals_[index]);
  }
  return std::nullopt;
}

void FeatureFinder::gather(Proposal& proposal) {
  proposal.supporters.clear();
  proposal.support = 0.0;
  const FeatureGauge gauge(proposal.feature, params_);
  std::size_t scan = std::numeric_limits<std::size_t>::max();
  double best_m = 0.0;
  double best_weight = 0.0;
  for (const std::size_t i : gate_.passing(proposal.feature)) {
    const auto misfit_m = gauge.misfit_m(sightings_[i]);
    if (!misfit_m) {
      continue;
    }
    if (sightings_[i].scan != scan) {
      scan = sightings_[i].scan;
      proposal.supporters.push_back(i);
    } else if (*misfit_m < best_m) {
      proposal.supporters.back() = i;
      proposal.support -= best_weight;
    } else {
      continue;
    }
    best_m = *misfit_m;
    best_weight = gauge.weight(sightings_[i], *misfit_m);
    proposal.support += best_weight;
  }
  if (proposal.support >= params_.min_support) {
    proposal.support -= penalty(proposal);
  }
}

double FeatureFinder::penalty(const Proposal& proposal) const {
  const std::vector<Sighting> sightings = sightings_of(proposal);
  const auto contradictions =
      static_cast<double>(contradiction_.count(proposal.feature, sightings));
  const double contradicted = params_.contradiction_weight * contradictions;
  if (proposal.feature.radius_m == 0.0) {
    return contradicted;
  }
  const double seen_rad = seen_over_rad(proposal.feature.value, sightings);
  return contradicted + params_.round_penalty +
         params_.one_sided_penalty * std::max(0.0, 1.0 - seen_rad / params_.one_sided_rad);
}

std::vector<Sighting> FeatureFinder::sightings_of(const Proposal& proposal) const {
  std::vector<Sighting> sightings;
  sightings.reserve(proposal.supporters.size());
  for (const std::size_t index : proposal.supporters) {
    sightings.push_back(sightings_[index]);
  }
  return sightings;
}

SupportedFeature FeatureFinder::take(Proposal proposal) {
  proposal.feature = fitted(proposal.feature, sightings_of(proposal), params_);
  const Proposal before = proposal;
  gather(proposal);
  if (proposal.supporters.size() < 2) {
    proposal = before;
  }
  for (const std::size_t index : proposal.supporters) {
    gate_.close(index);
  }
  return {proposal.feature, sightings_of(proposal)};
}

}  // namespace echomap::mapping
