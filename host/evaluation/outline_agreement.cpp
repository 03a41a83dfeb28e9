// SPDX-License-Identifier: MIT
#include "host/evaluation/outline_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace echomap::evaluation {
namespace {

using geometry::Polygon;

constexpr double kPieceM = 0.01;

/// Middles of pieces of equal length, about a centimetre each.
std::vector<Eigen::Vector2d> points_along_m(const Polygon& ring_m) {
  std::vector<Eigen::Vector2d> points_m;
  for (std::size_t i = 0; i < ring_m.size(); ++i) {
    const geometry::Segment side = geometry::side(ring_m, i);
    const auto pieces = std::max<long>(1, std::lround(side.length_m() / kPieceM));
    for (long piece = 0; piece < pieces; ++piece) {
      const double share = (static_cast<double>(piece) + 0.5) / static_cast<double>(pieces);
      points_m.emplace_back(side.from_m + share * (side.to_m - side.from_m));
    }
  }
  return points_m;
}

double corner_rmse_m(const Polygon& outline_m, const Polygon& room_m) {
  double sum_m2 = 0.0;
  for (const Eigen::Vector2d& corner_m : room_m) {
    double nearest_m2 = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& found_m : outline_m) {
      nearest_m2 = std::min(nearest_m2, (found_m - corner_m).squaredNorm());
    }
    sum_m2 += nearest_m2;
  }
  return std::sqrt(sum_m2 / static_cast<double>(room_m.size()));
}

double outline_rmse_m(const Polygon& outline_m, const Polygon& room_m) {
  double sum_m2 = 0.0;
  std::size_t count = 0;
  for (const auto& [from_m, to_m] : {std::pair(outline_m, room_m), std::pair(room_m, outline_m)}) {
    for (const Eigen::Vector2d& point_m : points_along_m(from_m)) {
      const double distance_m = geometry::distance_to_sides_m(to_m, point_m);
      sum_m2 += distance_m * distance_m;
      ++count;
    }
  }
  return std::sqrt(sum_m2 / static_cast<double>(count));
}

}  // namespace

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
  Polygon outline_m;
  for (const Eigen::Vector2d& corner_m : outline->outline_m()) {
    outline_m.emplace_back(T_world_map * corner_m);
  }
  agreement.corners = outline_m.size();
  agreement.corner_rmse_m = corner_rmse_m(outline_m, room_m);
  agreement.outline_rmse_m = outline_rmse_m(outline_m, room_m);
  return agreement;
}

}  // namespace echomap::evaluation
