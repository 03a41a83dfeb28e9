// SPDX-License-Identifier: MIT
#include "host/mapping/wall_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using Piece = MatchedWall::Piece;

Eigen::Vector2d along(const MatchedWall& wall) {
  return geometry::perpendicular(geometry::unit_vector(wall.normal_rad));
}

Eigen::Vector2d point_on(const MatchedWall& wall, double at_m) {
  return wall.offset_m * geometry::unit_vector(wall.normal_rad) + at_m * along(wall);
}

/// Where two lines cross, along each of them.
struct Crossing {
  double on_first_m = 0.0;
  double on_second_m = 0.0;
};

std::optional<Crossing> crossing_of(const MatchedWall& first,
                                    const MatchedWall& second,
                                    double min_angle_rad) {
  const Eigen::Vector2d first_normal = geometry::unit_vector(first.normal_rad);
  const Eigen::Vector2d second_normal = geometry::unit_vector(second.normal_rad);
  const double sine = geometry::cross(first_normal, second_normal);
  if (std::abs(sine) < std::sin(min_angle_rad)) {
    return std::nullopt;
  }
  const double first_m = (second.offset_m - first.offset_m * first_normal.dot(second_normal)) /
                         along(first).dot(second_normal);
  return Crossing{first_m, along(second).dot(point_on(first, first_m))};
}

bool comes_near(const MatchedWall& wall, double at_m, double reach_m) {
  return std::any_of(wall.pieces.begin(), wall.pieces.end(), [&](const Piece& piece) {
    return at_m > piece.from_m - reach_m && at_m < piece.to_m + reach_m;
  });
}

/// Finds how far the ends of pieces go on.
class CornerFinder {
 public:
  CornerFinder(const std::vector<MatchedWall>& walls,
               const std::vector<ScanSurfaces>& scans,
               const CornerJoiningParams& params)
      : walls_(walls), params_(params) {
    for (const ScanSurfaces& scan : scans) {
      for (const SonarSurface& surface : scan.surfaces) {
        sights_.push_back(
            {scan.center_m,
             scan.center_m + surface.range_m * geometry::unit_vector(surface.bearing_rad)});
      }
    }
  }

  /// From an end at `end_m`, upwards or downwards along its wall, to the nearest corner.
  std::optional<double> corner_m(std::size_t index, double end_m, double up) const {
    const MatchedWall& wall = walls_[index];
    double nearest_m = params_.reach_m;
    std::optional<double> corner;
    for (std::size_t other = 0; other < walls_.size(); ++other) {
      const auto crossing =
          other == index ? std::nullopt : crossing_of(wall, walls_[other], params_.min_angle_rad);
      if (!crossing) {
        continue;
      }
      const double beyond_m = up * (crossing->on_first_m - end_m);
      if (beyond_m > 0.0 && beyond_m < nearest_m &&
          comes_near(walls_[other], crossing->on_second_m, params_.reach_m)) {
        nearest_m = beyond_m;
        corner = crossing->on_first_m;
      }
    }
    return corner && !is_seen_through({point_on(wall, end_m), point_on(wall, *corner)})
               ? corner
               : std::nullopt;
  }

 private:
  bool is_seen_through(const geometry::Segment& gap) const {
    const Eigen::Vector2d along_gap = (gap.to_m - gap.from_m).normalized();
    return std::any_of(sights_.begin(), sights_.end(), [&](const geometry::Segment& sight) {
      const double behind_m = std::abs(geometry::cross(along_gap, sight.to_m - gap.from_m));
      return behind_m > params_.behind_m && geometry::cross_properly(sight, gap);
    });
  }

  const std::vector<MatchedWall>& walls_;
  const CornerJoiningParams& params_;
  std::vector<geometry::Segment> sights_;
};

}  // namespace

std::vector<MatchedWall> joined_at_corners(std::vector<MatchedWall> walls,
                                           const std::vector<ScanSurfaces>& scans,
                                           const CornerJoiningParams& params) {
  const std::vector<MatchedWall> seen = walls;
  const CornerFinder finder(seen, scans, params);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (Piece& piece : walls[i].pieces) {
      piece.to_m = finder.corner_m(i, piece.to_m, 1.0).value_or(piece.to_m);
      piece.from_m = finder.corner_m(i, piece.from_m, -1.0).value_or(piece.from_m);
    }
  }
  return walls;
}

}  // namespace echomap::mapping
