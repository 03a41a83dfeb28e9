// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/slam/data_association.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/provisional_landmarks.hpp"

namespace echomap::slam {

/// How sightings find their landmarks.
enum class AssociationMethod : std::uint8_t { kNearestNeighbour, kJointCompatibility };

/// How sightings of one instant update the filter.
struct LandmarkUpdateParams {
  AssociationMethod method = AssociationMethod::kJointCompatibility;
  AssociationParams association{};
  ProvisionalLandmarksParams provisional{};
};

/// Finds the landmarks that sightings are of: those that are known correct the state, those that
/// are not are added once they have been seen often enough.
class LandmarkUpdate {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit LandmarkUpdate(const LandmarkUpdateParams& params = {});

  /// Adds what the first robot of `filter` sees from its pose. Returns minus twice the log
  /// likelihood of the sightings; one of no known landmark is as likely as one from anywhere in a
  /// room.
  double add_sightings(std::span<const LandmarkSighting> sightings,
                       const geometry::Pose2& T_odom_robot,
                       EkfSlamFilter& filter);

 private:
  std::vector<Candidate> paired(std::span<const Candidate> candidates,
                                const EkfSlamFilter& filter) const;
  void extend(std::span<const LandmarkSighting> sightings,
              std::span<const std::size_t> unknown,
              const geometry::Pose2& T_odom_robot,
              EkfSlamFilter& filter);

  LandmarkUpdateParams params_;
  ProvisionalLandmarks provisional_;
};

}  // namespace echomap::slam
