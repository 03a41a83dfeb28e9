// SPDX-License-Identifier: MIT
#include "host/mapping/wall_completion.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using geometry::Segment;
using Piece = MatchedWall::Piece;

/// Steps of a track that are longer are no drive.
constexpr double kMaxTrackStepM = 0.5;

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

Segment sight(const Eigen::Vector2d& from_m, double bearing_rad, double range_m) {
  return {from_m, from_m + range_m * geometry::unit_vector(bearing_rad)};
}

/// From where each surface was seen to where it is; surfaces of features are where these are.
std::vector<Segment> sights_of(const MatchedSurfaces& matched,
                               const std::vector<ScanSurfaces>& scans) {
  std::vector<Segment> sights;
  std::set<std::pair<std::size_t, std::size_t>> explained;
  for (const auto& [feature, supporters] : matched.features) {
    explained.insert(supporters.begin(), supporters.end());
    for (const auto& [scan, index] : supporters) {
      const FeatureView view = view_from(scans[scan].center_m, feature);
      sights.push_back(sight(scans[scan].center_m, view.bearing_rad, view.range_m));
    }
  }
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (std::size_t i = 0; i < scans[scan].surfaces.size(); ++i) {
      if (const SonarSurface& surface = scans[scan].surfaces[i]; !explained.contains({scan, i})) {
        sights.push_back(sight(scans[scan].center_m, surface.bearing_rad, surface.range_m));
      }
    }
  }
  return sights;
}

}  // namespace

double end_excess_m(const Eigen::Vector2d& from_m, const Segment& gap) {
  const Eigen::Vector2d along = (gap.to_m - gap.from_m).normalized();
  const double foot_m = along.dot(from_m - gap.from_m);
  const double inside_m = std::min(foot_m, gap.length_m() - foot_m);
  const double distance_m = std::abs(geometry::cross(along, from_m - gap.from_m));
  return inside_m > 0.0 ? std::hypot(inside_m, distance_m) - distance_m : 0.0;
}

std::vector<Piece> gaps_between(const std::vector<Piece>& heard, const Piece& piece) {
  std::vector<Piece> gaps;
  double end_m = piece.from_m;
  for (const Piece& known : heard) {
    if (known.to_m >= piece.from_m && known.from_m <= piece.to_m) {
      if (known.from_m > end_m) {
        gaps.push_back({end_m, known.from_m});
      }
      end_m = std::max(end_m, known.to_m);
    }
  }
  if (piece.to_m > end_m) {
    gaps.push_back({end_m, piece.to_m});
  }
  return gaps;
}

WallCompletion::WallCompletion(const MatchedSurfaces& matched,
                               const std::vector<ScanSurfaces>& scans,
                               const std::vector<Eigen::Vector2d>& track_m,
                               const WallCompletionParams& params)
    : params_(params), scans_(scans), sights_(sights_of(matched, scans)) {
  for (std::size_t i = 1; i < track_m.size(); ++i) {
    if ((track_m[i] - track_m[i - 1]).norm() <= kMaxTrackStepM) {
      track_.push_back({track_m[i - 1], track_m[i]});
    }
  }
}

std::vector<MatchedWall> WallCompletion::completed(const MatchedSurfaces& matched) const {
  std::vector<MatchedWall> walls = matched.walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    walls[i].pieces = without_doors(matched.walls[i]);
    walls[i].pieces = bridged(walls[i]);
    for (Piece& piece : walls[i].pieces) {
      piece.to_m = prolonged_m(matched, i, piece.to_m, 1.0);
      piece.from_m = prolonged_m(matched, i, piece.from_m, -1.0);
    }
  }
  return walls;
}

/// The pieces without the stretches that nobody has heard, or where a door's frame may have
/// answered, and that a stop right before them has told from a wall.
std::vector<Piece> WallCompletion::without_doors(const MatchedWall& wall) const {
  std::vector<Piece> open;
  for (const Piece& piece : wall.pieces) {
    const auto gaps = gaps_between(wall.heard, piece);
    open.insert(open.end(), gaps.begin(), gaps.end());
  }
  for (const Piece& door : doors_left_by_echoes(wall, params_.doors)) {
    open.push_back({door.from_m + params_.door_side_m, door.to_m - params_.door_side_m});
  }
  std::erase_if(open, [&](const Piece& gap) {
    return is_closed({point_on(wall, gap.from_m), point_on(wall, gap.to_m)});
  });
  std::ranges::stable_sort(open, {}, &Piece::from_m);
  std::vector<Piece> pieces;
  for (const Piece& piece : wall.pieces) {
    const auto left = gaps_between(open, piece);
    pieces.insert(pieces.end(), left.begin(), left.end());
  }
  return pieces;
}

std::vector<Piece> WallCompletion::bridged(const MatchedWall& wall) const {
  std::vector<Piece> pieces;
  for (const Piece& piece : wall.pieces) {
    const bool is_near = !pieces.empty() && piece.from_m - pieces.back().to_m <= params_.bridged_m;
    if (is_near && is_closed({point_on(wall, pieces.back().to_m), point_on(wall, piece.from_m)})) {
      pieces.back().to_m = std::max(pieces.back().to_m, piece.to_m);
    } else {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/// From an end at `end_m`, upwards or downwards along its wall.
double WallCompletion::prolonged_m(const MatchedSurfaces& matched,
                                   std::size_t wall,
                                   double end_m,
                                   double up) const {
  const MatchedWall& prolonged = matched.walls[wall];
  auto to_m = corner_m(matched.walls, wall, end_m, up);
  to_m = to_m ? to_m : edge_m(matched, prolonged, end_m, up);
  return to_m && is_closed({point_on(prolonged, end_m), point_on(prolonged, *to_m)}) ? *to_m
                                                                                     : end_m;
}

std::optional<double> WallCompletion::corner_m(const std::vector<MatchedWall>& walls,
                                               std::size_t wall,
                                               double end_m,
                                               double up) const {
  double nearest_m = params_.reach_m;
  std::optional<double> corner;
  for (std::size_t other = 0; other < walls.size(); ++other) {
    const auto crossing = other == wall
                              ? std::nullopt
                              : crossing_of(walls[wall], walls[other], params_.min_angle_rad);
    if (!crossing) {
      continue;
    }
    const double beyond_m = up * (crossing->on_first_m - end_m);
    if (beyond_m > 0.0 && beyond_m < nearest_m &&
        comes_near(walls[other], crossing->on_second_m, params_.reach_m)) {
      nearest_m = beyond_m;
      corner = crossing->on_first_m;
    }
  }
  return corner;
}

/// The farthest post on the line of a wall, beyond one of its ends.
std::optional<double> WallCompletion::edge_m(const MatchedSurfaces& matched,
                                             const MatchedWall& wall,
                                             double end_m,
                                             double up) const {
  std::optional<double> edge;
  double max_beyond_m = 0.0;
  for (const auto& [feature, supporters] : matched.features) {
    if (feature.kind == LandmarkKind::kWall) {
      continue;
    }
    const double off_m = geometry::unit_vector(wall.normal_rad).dot(feature.value) - wall.offset_m;
    const double at_m = along(wall).dot(feature.value);
    const double beyond_m = up * (at_m - end_m);
    if (std::abs(off_m) <= params_.edge_off_line_m && beyond_m > max_beyond_m &&
        beyond_m <= params_.edge_reach_m) {
      max_beyond_m = beyond_m;
      edge = at_m;
    }
  }
  return edge;
}

bool WallCompletion::is_closed(const Segment& gap) const {
  const Eigen::Vector2d along_gap = (gap.to_m - gap.from_m).normalized();
  const bool is_seen_through = std::any_of(sights_.begin(), sights_.end(), [&](const Segment& one) {
    const double behind_m = std::abs(geometry::cross(along_gap, one.to_m - gap.from_m));
    return behind_m > params_.behind_m && geometry::cross_properly(one, gap);
  });
  return !is_seen_through && !is_heard_open(gap) &&
         std::none_of(track_.begin(), track_.end(), [&](const Segment& step) {
           return geometry::cross_properly(step, gap);
         });
}

bool WallCompletion::is_heard_open(const Segment& gap) const {
  return std::any_of(scans_.begin(), scans_.end(), [&](const ScanSurfaces& scan) {
    return hears_open(scan, gap);
  });
}

/// A wall answers a stop from the foot of the perpendicular, the frame of a door from where it is.
bool WallCompletion::hears_open(const ScanSurfaces& scan, const Segment& gap) const {
  const Eigen::Vector2d along_gap = (gap.to_m - gap.from_m).normalized();
  const double foot_m = along_gap.dot(scan.center_m - gap.from_m);
  const double inside_m = std::min(foot_m, gap.length_m() - foot_m);
  const Eigen::Vector2d to_foot_m = gap.from_m + foot_m * along_gap - scan.center_m;
  const double distance_m = to_foot_m.norm();
  if (inside_m < params_.faced_inside_m || distance_m > params_.faced_range_m) {
    return false;
  }
  const double bearing_rad = std::atan2(to_foot_m.y(), to_foot_m.x());
  std::size_t looks = 0;
  std::size_t answers = 0;
  double farther_m = 0.0;
  for (const sensors::Beam& look : scan.looks) {
    if (std::abs(geometry::angle_between(bearing_rad, look.bearing_rad)) <=
        params_.faced_half_angle_rad) {
      ++looks;
      if (look.range_m && *look.range_m <= distance_m + params_.behind_m) {
        ++answers;
        farther_m += *look.range_m - distance_m;
      }
    }
  }
  const double excess_m = end_excess_m(scan.center_m, gap);
  const bool is_of_ends = excess_m >= params_.told_apart_m && answers > 0 &&
                          farther_m > 0.5 * excess_m * static_cast<double>(answers);
  return (looks > 0 && answers == 0) || is_of_ends;
}

}  // namespace echomap::mapping
