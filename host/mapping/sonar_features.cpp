// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_features.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/point_buckets.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

std::vector<geometry::Segment> segments_of(const std::vector<MatchedWall>& walls) {
  std::vector<geometry::Segment> segments;
  for (const MatchedWall& wall : walls) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    const Eigen::Vector2d foot_m = wall.offset_m * normal;
    for (const auto& piece : wall.pieces) {
      segments.push_back({foot_m + piece.from_m * along, foot_m + piece.to_m * along});
    }
  }
  return segments;
}

/// What of the pieces of a wall lies beside others of it.
MatchedWall left_of(const MatchedWall& wall, const std::vector<MatchedWall::Piece>& others) {
  MatchedWall left{wall.normal_rad, wall.offset_m, {}};
  for (const auto& piece : wall.pieces) {
    const auto gaps = gaps_between(others, piece);
    left.pieces.insert(left.pieces.end(), gaps.begin(), gaps.end());
  }
  return left;
}

/// The gaps that are left between the pieces of a wall, but for those of which nothing is known.
std::vector<MatchedWall::Piece> open_gaps(const MatchedWall& wall, double max_m) {
  std::vector<MatchedWall::Piece> gaps;
  for (std::size_t i = 1; i < wall.pieces.size(); ++i) {
    const MatchedWall::Piece gap{wall.pieces[i - 1].to_m, wall.pieces[i].from_m};
    if (gap.to_m > gap.from_m && gap.to_m - gap.from_m <= max_m) {
      gaps.push_back(gap);
    }
  }
  return gaps;
}

/// Whether most of a feature's sightings run through walls.
bool is_image(const MatchedFeature& feature,
              const std::vector<ScanSurfaces>& scans,
              const std::vector<geometry::Segment>& walls,
              double clearance_m) {
  std::size_t hidden = 0;
  for (const auto& [scan, index] : feature.supporters) {
    const Eigen::Vector2d& from_m = scans[scan].center_m;
    const FeatureView view = view_from(from_m, feature.feature);
    const geometry::Segment sight{
        from_m, from_m + (view.range_m - clearance_m) * geometry::unit_vector(view.bearing_rad)};
    hidden += std::any_of(walls.begin(), walls.end(), [&](const geometry::Segment& wall) {
      return geometry::cross_properly(sight, wall);
    });
  }
  return 2 * hidden > feature.supporters.size();
}

MatchedSurfaces without_images(const MatchedSurfaces& matched,
                               const std::vector<ScanSurfaces>& scans,
                               const std::vector<geometry::Segment>& walls,
                               double clearance_m) {
  MatchedSurfaces real;
  std::size_t wall = 0;
  for (const MatchedFeature& feature : matched.features) {
    const bool is_wall = feature.feature.kind == LandmarkKind::kWall;
    if (!is_image(feature, scans, walls, clearance_m)) {
      real.features.push_back(feature);
      if (is_wall) {
        real.walls.push_back(matched.walls[wall]);
      }
    }
    wall += is_wall ? 1 : 0;
  }
  return real;
}

/// Where the robot's centre has been, for many questions about one clearance and more.
class Track {
 public:
  Track(const std::vector<Eigen::Vector2d>& track_m, double max_clearance_m)
      : buckets_(max_clearance_m) {
    for (const Eigen::Vector2d& robot_m : track_m) {
      buckets_.add(robot_m, robot_m);
    }
  }

  bool comes_within(const Eigen::Vector2d& point_m, double clearance_m) const {
    bool is_near = false;
    buckets_.visit_near(point_m, [&](const Eigen::Vector2d& robot_m) {
      is_near |= (robot_m - point_m).norm() < clearance_m;
    });
    return is_near;
  }

 private:
  geometry::PointBuckets<Eigen::Vector2d> buckets_;
};

FittedCircle circle_of(const MatchedFeature& feature,
                       const std::vector<ScanSurfaces>& scans,
                       double seen_rim_rad) {
  FittedCircle circle{feature.feature.value, feature.feature.radius_m, {}};
  for (const auto& [scan, index] : feature.supporters) {
    const Eigen::Vector2d offset_m = scans[scan].center_m - circle.center_m;
    const double seen_rad = std::atan2(offset_m.y(), offset_m.x());
    for (std::size_t i = 0; i < FittedCircle::kSectors; ++i) {
      const double sector_rad =
          -std::numbers::pi + (static_cast<double>(i) + 0.5) * FittedCircle::kSectorRad;
      if (std::abs(geometry::angle_between(seen_rad, sector_rad)) <= seen_rim_rad) {
        circle.seen.set(i);
      }
    }
  }
  return circle;
}

}  // namespace

SonarFeatures sonar_features(const MatchedSurfaces& matched,
                             const std::vector<ScanSurfaces>& scans,
                             const std::vector<Eigen::Vector2d>& track_m,
                             const SonarFeaturesParams& params) {
  const WallCompletion completion(matched, scans, track_m, params.completion);
  const MatchedSurfaces real = without_images(
      matched, scans, segments_of(completion.completed(matched)), params.image_clearance_m);
  const std::vector<MatchedWall> completed = completion.completed(real);
  std::vector<MatchedWall> unobserved;
  std::vector<MatchedWall> unheard;
  for (std::size_t i = 0; i < completed.size(); ++i) {
    unobserved.push_back(left_of(completed[i], real.walls[i].pieces));
    unheard.push_back(left_of(completed[i], completed[i].heard));
    const auto doors = doors_left_by_echoes(completed[i], params.completion.doors);
    auto& pieces = unheard.back().pieces;
    pieces.insert(pieces.end(), doors.begin(), doors.end());
    const auto gaps = open_gaps(completed[i], params.completion.bridged_m);
    pieces.insert(pieces.end(), gaps.begin(), gaps.end());
  }
  SonarFeatures features{segments_of(completed), {}, segments_of(unobserved), segments_of(unheard)};
  double max_radius_m = 0.0;
  for (const MatchedFeature& feature : real.features) {
    max_radius_m = std::max(max_radius_m, feature.feature.radius_m);
  }
  const Track track(track_m, max_radius_m + params.track_clearance_m);
  for (const MatchedFeature& feature : real.features) {
    const EchoFeature& echo = feature.feature;
    if (echo.kind == LandmarkKind::kPoint &&
        !track.comes_within(echo.value, echo.radius_m + params.track_clearance_m)) {
      features.circles.push_back(circle_of(feature, scans, params.seen_rim_rad));
    }
  }
  return features;
}

}  // namespace echomap::mapping
