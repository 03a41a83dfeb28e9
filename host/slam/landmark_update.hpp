// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/slam/data_association.hpp"
#include "host/slam/ekf_slam.hpp"
#include "host/slam/provisional_landmarks.hpp"

namespace echomap::slam {

/// How sightings find their landmarks.
enum class AssociationMethod : std::uint8_t { kNearestNeighbour, kJointCompatibility };

/// How sightings of one instant come into the filter.
struct LandmarkUpdateParams {
  AssociationMethod method = AssociationMethod::kJointCompatibility;
  AssociationParams association{};
  ProvisionalLandmarksParams provisional{};
};

/// Finds the landmarks that sightings are of: those that are known correct the state, those that
/// are not are added once they have been seen often enough.
class LandmarkUpdate {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit LandmarkUpdate(const LandmarkUpdateParams& params = {});

  /// Takes what the first robot of `filter` sees from where it stands. Answers how surprising that
  /// was: minus twice the logarithm of how likely the sightings were. One of no landmark is as
  /// likely as one from anywhere in a room.
  double see(std::span<const LandmarkSighting> sightings,
             const geometry::Pose2& T_odom_robot,
             EkfSlam& filter);

 private:
  std::vector<Candidate> paired(std::span<const Candidate> candidates, const EkfSlam& filter) const;
  void extend(std::span<const LandmarkSighting> sightings,
              std::span<const std::size_t> unknown,
              const geometry::Pose2& T_odom_robot,
              EkfSlam& filter);

  LandmarkUpdateParams params_;
  ProvisionalLandmarks provisional_;
};

}  // namespace echomap::slam
