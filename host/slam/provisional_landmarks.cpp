// SPDX-License-Identifier: MIT
#include "host/slam/provisional_landmarks.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::slam {

ProvisionalLandmarks::ProvisionalLandmarks(const ProvisionalLandmarksParams& params)
    : params_(params) {
  geometry::ParameterValidator("provisional landmarks")
      .positive("max_m", params.max_m)
      .positive("max_rad", params.max_rad);
}

bool ProvisionalLandmarks::is_near(const Waiting& waiting, const Eigen::Vector2d& place) const {
  if (waiting.kind == LandmarkKind::kPoint) {
    return (waiting.place - place).norm() <= params_.max_m;
  }
  const Eigen::Vector2d off = innovation(place, waiting.place);
  return std::abs(off.x()) <= params_.max_m && std::abs(off.y()) <= params_.max_rad;
}

std::optional<std::size_t> ProvisionalLandmarks::match(const LandmarkSighting& sighting,
                                                       const Eigen::Vector2d& place) const {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const Waiting& waiting = waiting_[i];
    if (waiting.kind != sighting.kind || waiting.label != sighting.label ||
        waiting.last_scan == scan_ || !is_near(waiting, place)) {
      continue;
    }
    if (!nearest || (waiting.place - place).norm() < (waiting_[*nearest].place - place).norm()) {
      nearest = i;
    }
  }
  return nearest;
}

std::vector<LandmarkSighting> ProvisionalLandmarks::confirmed(
    std::span<const LandmarkSighting> sightings, const geometry::Pose2& T_odom_robot) {
  ++scan_;
  std::vector<LandmarkSighting> confirmed;
  for (const LandmarkSighting& sighting : sightings) {
    const Eigen::Vector2d place = placed_landmark(sighting, T_odom_robot).landmark;
    std::optional<std::size_t> known = match(sighting, place);
    if (!known) {
      known = waiting_.size();
      waiting_.push_back({sighting.kind, sighting.label, place, 0, scan_});
    }
    Waiting& waiting = waiting_[*known];
    waiting.place = place;
    waiting.last_scan = scan_;
    if (++waiting.sightings >= params_.sightings) {
      confirmed.push_back(sighting);
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(*known));
    }
  }
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    return waiting.last_scan + params_.forgotten_after_scans < scan_;
  });
  return confirmed;
}

}  // namespace echomap::slam
