// SPDX-License-Identifier: MIT
#include "host/evaluation/outline_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echomap::evaluation {

geometry::Polygon first_ring(const std::vector<geometry::Segment>& walls) {
  geometry::Polygon ring;
  for (const geometry::Segment& wall : walls) {
    ring.push_back(wall.from_m);
    if (wall.to_m == ring.front()) {
      return ring;
    }
  }
  return {};
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
