// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/landmark_sighting.hpp"

namespace echomap::slam {

/// When something that was seen is taken into the map; ours.
struct ProvisionalLandmarksParams {
  /// It has been seen so often: people and bad fits have not.
  std::size_t sightings = 4;
  /// Sightings of one thing lie no farther apart, by odometry; of a wall, that far aside and
  /// turned.
  double max_m = 0.3;
  double max_rad = 0.15;
  /// What has not been seen for as many scans is forgotten.
  std::size_t forgotten_after_scans = 20;
};

/// Things seen that are not in the map yet (Thrun, Burgard and Fox 2005, section 10.3.3). They wait
/// in the frame of the odometry, which is good for as long as they wait, and tell nothing of the
/// robot's pose until they are in the map.
class ProvisionalLandmarks {
 public:
  /// Throws std::invalid_argument for lengths that are not above 0.
  explicit ProvisionalLandmarks(const ProvisionalLandmarksParams& params = {});

  /// Takes sightings of one scan that are of no landmark; answers those that have now been seen
  /// often enough. They do not wait any longer.
  std::vector<LandmarkSighting> confirmed(std::span<const LandmarkSighting> sightings,
                                          const geometry::Pose2& T_odom_robot);
  std::size_t waiting() const { return waiting_.size(); }

 private:
  struct Waiting {
    LandmarkKind kind = LandmarkKind::kPoint;
    int label = 0;
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    std::size_t sightings = 0;
    std::size_t last_scan = 0;
  };

  std::optional<std::size_t> match(const LandmarkSighting& sighting,
                                   const Eigen::Vector2d& place) const;
  bool is_near(const Waiting& waiting, const Eigen::Vector2d& place) const;

  ProvisionalLandmarksParams params_;
  std::vector<Waiting> waiting_;
  std::size_t scan_ = 0;
};

}  // namespace echomap::slam
