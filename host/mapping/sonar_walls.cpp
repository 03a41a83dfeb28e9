// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/point_buckets.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

using geometry::Segment;

/// Off the axis by more than this share of the half angle, silence says little of a wall.
constexpr double kSureShare = 0.6;
/// A foot so near to the piece's end is still on it.
constexpr double kEndM = 0.05;
/// Circles that differ more have a tangent at right angles to nothing they heard.
constexpr double kSteepest = 0.9;

/// Pieces that hide others are drawn in cells of this size; a wall so near to a foot is its own.
constexpr double kWallCellM = 0.05;
constexpr double kOwnWallM = 0.1;

/// A wall as one view hears it: its foot is `range_m` away towards `normal_rad`.
struct HeardWall {
  Eigen::Vector2d origin_m;
  double range_m = 0.0;
  double normal_rad = 0.0;

  Eigen::Vector2d foot_m() const { return origin_m + range_m * geometry::unit_vector(normal_rad); }
};

/// A piece of wall with the places from which its two ends have been heard.
struct PieceOfWall {
  Segment wall;
  Eigen::Vector2d from_origin_m;
  Eigen::Vector2d to_origin_m;

  double range_m() const {
    return std::max((wall.from_m - from_origin_m).norm(), (wall.to_m - to_origin_m).norm());
  }
};

/// Cells that walls stand in.
class WalledCells {
 public:
  void draw(const Segment& wall) {
    const Eigen::Vector2d direction = (wall.to_m - wall.from_m).normalized();
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are far wider
    for (double along_m = 0.0; along_m < wall.length_m(); along_m += kWallCellM / 4.0) {
      cells_.insert(key(wall.from_m + along_m * direction));
    }
  }
  /// Whether a wall stands between the two points, and not at the second.
  bool stand_between(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& foot_m) const {
    const Eigen::Vector2d offset_m = foot_m - origin_m;
    const double free_m = offset_m.norm() - kOwnWallM;
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are far wider
    for (double along_m = 0.0; along_m < free_m; along_m += kWallCellM / 2.0) {
      if (cells_.count(key(origin_m + along_m * offset_m.normalized())) > 0) {
        return true;
      }
    }
    return false;
  }

 private:
  static std::int64_t key(const Eigen::Vector2d& point_m) {
    return geometry::square_key(point_m, kWallCellM);
  }

  std::unordered_set<std::int64_t> cells_;
};

/// The pieces that no nearer one hides. A post before a wall that sound gets along to is heard as
/// if pieces of wall went through it at a slant, half of them behind the wall.
std::vector<Segment> without_hidden(std::vector<PieceOfWall> pieces) {
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return a.range_m() < b.range_m();
  });
  std::vector<Segment> walls;
  WalledCells nearer;
  for (const PieceOfWall& piece : pieces) {
    if (!nearer.stand_between(piece.from_origin_m, piece.wall.from_m) &&
        !nearer.stand_between(piece.to_origin_m, piece.wall.to_m)) {
      nearer.draw(piece.wall);
      walls.push_back(piece.wall);
    }
  }
  return walls;
}

class WallFinder {
 public:
  WallFinder(const std::vector<SonarView>& views,
             double beam_half_angle_rad,
             double max_range_m,
             const SonarWallParams& params)
      : views_(views),
        beam_half_angle_rad_(beam_half_angle_rad),
        max_range_m_(max_range_m),
        params_(params),
        index_(std::max(max_range_m, params.max_baseline_m)) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      index_.add(views[i].origin_m, i);
    }
  }

  std::vector<Segment> find() {
    for (std::size_t i = 0; i < views_.size(); ++i) {
      index_.visit_near(views_[i].origin_m, [&](std::size_t j) {
        const double apart_m = (views_[j].origin_m - views_[i].origin_m).norm();
        if (j > i && apart_m >= params_.min_baseline_m && apart_m <= params_.max_baseline_m) {
          add_tangents(views_[i], views_[j]);
        }
      });
    }
    return without_hidden(std::move(pieces_));
  }

 private:
  void add_tangents(const SonarView& one, const SonarView& other) {
    const Eigen::Vector2d apart_m = other.origin_m - one.origin_m;
    const double along_rad = std::atan2(apart_m.y(), apart_m.x());
    for (const sensors::Beam& near : one.beams) {
      for (const sensors::Beam& far : other.beams) {
        if (!near.range_m || !far.range_m) {
          continue;
        }
        const double slope = (*near.range_m - *far.range_m) / apart_m.norm();
        if (std::abs(slope) >= kSteepest) {
          continue;
        }
        for (const double side : {-1.0, 1.0}) {
          add_tangent(one, near, other, far, along_rad + side * std::acos(slope));
        }
      }
    }
  }

  void add_tangent(const SonarView& one,
                   const sensors::Beam& near,
                   const SonarView& other,
                   const sensors::Beam& far,
                   double normal_rad) {
    if (near.range_m && far.range_m && looks_along(one, near, normal_rad) &&
        looks_along(other, far, normal_rad)) {
      add_wall({one.origin_m, *near.range_m, normal_rad},
               {other.origin_m, *far.range_m, normal_rad});
    }
  }

  double off_axis_rad(const sensors::Beam& beam, double bearing_rad) const {
    return std::abs(geometry::angle_between(beam.bearing_rad, bearing_rad));
  }

  /// Whether `beam` is the view's nearest to that direction, and all others that hold it agree.
  bool looks_along(const SonarView& view, const sensors::Beam& beam, double normal_rad) const {
    const double off_rad = off_axis_rad(beam, normal_rad);
    if (off_rad > beam_half_angle_rad_) {
      return false;
    }
    return std::all_of(view.beams.begin(), view.beams.end(), [&](const sensors::Beam& next) {
      const double next_off_rad = off_axis_rad(next, normal_rad);
      const bool hears_nothing_else =
          next_off_rad > beam_half_angle_rad_ ||
          (next.range_m && *next.range_m <= *beam.range_m + params_.range_tolerance_m);
      return next_off_rad >= off_rad && hears_nothing_else;
    });
  }

  void add_wall(const HeardWall& one, const HeardWall& other) {
    const Segment wall{one.foot_m(), other.foot_m()};
    if (wall.length_m() > params_.longest_piece_m) {
      return;
    }
    bool missed = false;
    index_.visit_near(wall.from_m, [&](std::size_t i) {
      missed = missed || misses(views_[i], wall, one.normal_rad);
    });
    if (!missed) {
      pieces_.push_back({wall, one.origin_m, other.origin_m});
    }
  }

  /// Whether the view has its foot on the wall, and heard something beyond or nothing.
  bool misses(const SonarView& view, const Segment& wall, double normal_rad) const {
    const Eigen::Vector2d normal = geometry::unit_vector(normal_rad);
    const double range_m = normal.dot(wall.from_m - view.origin_m);
    const Eigen::Vector2d foot_m = view.origin_m + range_m * normal;
    const bool hearable = range_m > kEndM && range_m < max_range_m_ - kEndM &&
                          geometry::distance_m(wall, foot_m) <= kEndM;
    if (!hearable) {
      return false;
    }
    bool asked = false;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const sensors::Beam& beam : view.beams) {
      if (off_axis_rad(beam, normal_rad) <= kSureShare * beam_half_angle_rad_) {
        asked = true;
        nearest_m = std::min(nearest_m, beam.range_m.value_or(nearest_m));
      }
    }
    return asked && nearest_m > range_m + params_.range_tolerance_m;
  }

  const std::vector<SonarView>& views_;
  double beam_half_angle_rad_;
  double max_range_m_;
  SonarWallParams params_;
  geometry::PointBuckets<std::size_t> index_;
  std::vector<PieceOfWall> pieces_;
};

}  // namespace

std::vector<Segment> find_sonar_walls(const std::vector<SonarView>& views,
                                      double beam_half_angle_rad,
                                      double max_range_m,
                                      const SonarWallParams& params) {
  return WallFinder(views, beam_half_angle_rad, max_range_m, params).find();
}

}  // namespace echomap::mapping
