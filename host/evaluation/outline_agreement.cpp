// SPDX-License-Identifier: MIT
#include "host/evaluation/outline_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echomap::evaluation {

std::vector<geometry::Polygon> closed_rings(const std::vector<geometry::Segment>& walls) {
  std::vector<geometry::Polygon> rings;
  geometry::Polygon ring;
  Eigen::Vector2d end_m = Eigen::Vector2d::Zero();
  for (const geometry::Segment& wall : walls) {
    if (wall.from_m != end_m) {
      ring.clear();
    }
    ring.push_back(wall.from_m);
    end_m = wall.to_m;
    if (end_m == ring.front()) {
      rings.push_back(ring);
      ring.clear();
    }
  }
  return rings;
}

geometry::Polygon first_ring(const std::vector<geometry::Segment>& walls) {
  const auto rings = closed_rings(walls);
  return rings.empty() ? geometry::Polygon() : rings.front();
}

std::vector<geometry::Polygon> obstacle_rings(const std::vector<geometry::Segment>& walls) {
  auto rings = closed_rings(walls);
  if (!rings.empty()) {
    rings.erase(rings.begin());
  }
  return rings;
}

OutlineAgreement score_outline(const std::optional<mapping::PolygonMap>& outline,
                               const geometry::Pose2& T_world_map,
                               const geometry::Polygon& room_m) {
  OutlineAgreement agreement;
  agreement.room_corners = room_m.size();
  if (!outline || room_m.empty()) {
    return agreement;
  }
  agreement.corners = outline->outline_m().size();
  double sum_m2 = 0.0;
  for (const Eigen::Vector2d& corner_m : room_m) {
    double nearest_m2 = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& told_m : outline->outline_m()) {
      nearest_m2 = std::min(nearest_m2, (T_world_map * told_m - corner_m).squaredNorm());
    }
    sum_m2 += nearest_m2;
  }
  agreement.corner_rmse_m = std::sqrt(sum_m2 / static_cast<double>(room_m.size()));
  return agreement;
}

}  // namespace echomap::evaluation
