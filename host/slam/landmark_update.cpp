// SPDX-License-Identifier: MIT
#include "host/slam/landmark_update.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "host/geometry/parameter_validator.hpp"
#include "host/slam/joint_compatibility.hpp"

namespace echomap::slam {

namespace {

/// Of a length of up to 5 m in any direction.
const double kNegativeLogDensityOfUnmatched = 2.0 * std::log(5.0 * 2.0 * std::numbers::pi);

void correct(std::span<const LandmarkSighting> sightings,
             std::span<const Candidate> pairs,
             EkfSlamFilter& filter) {
  std::vector<LinearSighting> linear;
  for (const Candidate& pair : pairs) {
    linear.push_back(pair.linear);
  }
  filter.update(linear);
  for (const Candidate& pair : pairs) {
    filter.note(sightings[pair.sighting], pair.landmark);
  }
}

double negative_log_evidence_of(std::size_t sightings, std::span<const Candidate> pairs) {
  double negative_log_evidence =
      kNegativeLogDensityOfUnmatched * static_cast<double>(sightings - pairs.size());
  for (const Candidate& pair : pairs) {
    negative_log_evidence += pair.unlikeliness + 2.0 * std::log(2.0 * std::numbers::pi);
  }
  return negative_log_evidence;
}

}  // namespace

LandmarkUpdate::LandmarkUpdate(const LandmarkUpdateParams& params)
    : params_(params), provisional_(params.provisional) {
  const AssociationParams& association = params.association;
  geometry::ParameterValidator("landmark update")
      .positive("association.gate", association.gate)
      .at_least("association.gate_of_new", association.gate_of_new, association.gate);
}

double LandmarkUpdate::add_sightings(std::span<const LandmarkSighting> sightings,
                                     const geometry::Pose2& T_odom_robot,
                                     EkfSlamFilter& filter) {
  const auto near = find_candidates(
      filter, sightings, params_.association.gate_of_new, params_.association.max_wall_gap_m);
  const auto pairs = paired(near, filter);
  const double negative_log_evidence = negative_log_evidence_of(sightings.size(), pairs);
  correct(sightings, pairs, filter);
  extend(sightings, new_sightings(sightings.size(), near), T_odom_robot, filter);
  return negative_log_evidence;
}

std::vector<Candidate> LandmarkUpdate::paired(std::span<const Candidate> candidates,
                                              const EkfSlamFilter& filter) const {
  std::vector<Candidate> within;
  std::copy_if(candidates.begin(),
               candidates.end(),
               std::back_inserter(within),
               [&](const Candidate& candidate) {
                 return candidate.squared_distance <= params_.association.gate;
               });
  return params_.method == AssociationMethod::kJointCompatibility
             ? jointly_compatible(filter, within, params_.association.max_steps)
             : nearest_neighbours(std::move(within));
}

void LandmarkUpdate::extend(std::span<const LandmarkSighting> sightings,
                            std::span<const std::size_t> unknown,
                            const geometry::Pose2& T_odom_robot,
                            EkfSlamFilter& filter) {
  std::vector<LandmarkSighting> unpaired;
  for (const std::size_t i : unknown) {
    unpaired.push_back(sightings[i]);
  }
  for (const LandmarkSighting& sighting : provisional_.confirmed(unpaired, T_odom_robot)) {
    filter.add(sighting);
  }
}

}  // namespace echomap::slam
