// SPDX-License-Identifier: MIT
#include "host/slam/data_association.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

/// A sighting where the robot believes it to be, and how unsure that is by axis.
struct Placed {
  Eigen::Vector2d landmark;
  Eigen::Vector2d variance;
};

Placed placed(const EkfSlamFilter& filter, const LandmarkSighting& sighting) {
  const localization::PoseGaussian belief = filter.belief(sighting.robot);
  const PlacedLandmark place = placed_landmark(sighting, belief.T_map_robot);
  const Eigen::Matrix2d covariance =
      place.jacobian_pose * belief.covariance * place.jacobian_pose.transpose() +
      place.by_value * sighting.noise * place.by_value.transpose();
  return {place.landmark, covariance.diagonal()};
}

/// Cheap, and never false for a pair within the gate: the variance of a difference is at most twice
/// the sum of both.
bool may_be_within(const Placed& seen,
                   const Landmark& landmark,
                   const Eigen::Vector2d& variance,
                   double gate) {
  const Eigen::Vector2d bound = 2.0 * gate * (seen.variance + variance);
  const Eigen::Vector2d off = innovation(seen.landmark, landmark.value);
  if (landmark.kind == LandmarkKind::kWall) {
    return off.y() * off.y() <= bound.y();
  }
  return (seen.landmark - landmark.value).squaredNorm() <= bound.sum();
}

bool is_on_the_wall(const EkfSlamFilter& filter,
                    const LandmarkSighting& sighting,
                    const Landmark& wall,
                    double max_gap_m) {
  const Pose2 T_map_sensor = filter.belief(sighting.robot).T_map_robot * sighting.T_robot_sensor;
  const double foot_m =
      geometry::perpendicular(geometry::unit_vector(wall.value.y())).dot(T_map_sensor.position_m());
  return foot_m + sighting.along_from_m <= wall.along_to_m + max_gap_m &&
         foot_m + sighting.along_to_m >= wall.along_from_m - max_gap_m;
}

std::optional<Candidate> candidate(const EkfSlamFilter& filter,
                                   const LandmarkSighting& sighting,
                                   std::size_t landmark,
                                   double gate) {
  const auto linear = filter.linearized(sighting, landmark);
  if (!linear) {
    return std::nullopt;
  }
  const Eigen::Matrix2d covariance = filter.covariance_between(*linear, *linear) + linear->noise;
  const double distance = linear->innovation.dot(covariance.llt().solve(linear->innovation));
  if (!(distance <= gate)) {
    return std::nullopt;
  }
  return Candidate{0, landmark, *linear, distance, distance + std::log(covariance.determinant())};
}

}  // namespace

std::vector<Candidate> find_candidates(const EkfSlamFilter& filter,
                                       std::span<const LandmarkSighting> sightings,
                                       double gate,
                                       double max_wall_gap_m) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const LandmarkSighting& sighting = sightings[i];
    const Placed seen = placed(filter, sighting);
    for (std::size_t k = 0; k < filter.landmarks().size(); ++k) {
      const Landmark& landmark = filter.landmarks()[k];
      if (landmark.kind != sighting.kind || landmark.label != sighting.label ||
          !may_be_within(seen, landmark, filter.landmark_variance(k), gate) ||
          (landmark.kind == LandmarkKind::kWall &&
           !is_on_the_wall(filter, sighting, landmark, max_wall_gap_m))) {
        continue;
      }
      if (auto found = candidate(filter, sighting, k, gate)) {
        found->sighting = i;
        candidates.push_back(*found);
      }
    }
  }
  return candidates;
}

std::vector<Candidate> nearest_neighbours(std::vector<Candidate> candidates) {
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const Candidate& left, const Candidate& right) {
        return left.unlikeliness < right.unlikeliness;
      });
  std::vector<Candidate> chosen;
  for (const Candidate& next : candidates) {
    const bool is_taken = std::any_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      return other.sighting == next.sighting || other.landmark == next.landmark;
    });
    if (!is_taken) {
      chosen.push_back(next);
    }
  }
  return chosen;
}

std::vector<std::size_t> new_sightings(std::size_t sightings,
                                       std::span<const Candidate> candidates) {
  std::vector<bool> is_known(sightings, false);
  for (const Candidate& candidate : candidates) {
    is_known[candidate.sighting] = true;
  }
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < sightings; ++i) {
    if (!is_known[i]) {
      unknown.push_back(i);
    }
  }
  return unknown;
}

}  // namespace echomap::slam
