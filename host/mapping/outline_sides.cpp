// SPDX-License-Identifier: MIT
#include "host/mapping/outline_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host/geometry/polygon_simplification.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/wall_lines.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::Segment;

/// Sides taken out at once: a notch has three, and the second neighbour may go with them.
constexpr std::size_t kMaxRemoved = 4;
constexpr double kMinSideM = 0.05;
/// Pieces of wall whose ends are this near to one line are one wall.
constexpr double kSameWallM = 0.05;
/// Sine of the angle between a side and the wall that it follows. The direction of a short piece of
/// border is not known well.
constexpr double kMaxMisalignment = 0.34;
constexpr double kMaxMisalignmentOfPiece = 0.64;

/// A straight side: a directed line and the points of the border, in order, that it stands for.
struct Side {
  DirectedLine line;
  std::vector<Eigen::Vector2d> points_m;
  bool follows_wall = false;
  bool is_known = false;
};

/// Midpoints of the border's cell edges.
Polygon edge_midpoints(const Polygon& border_m, double resolution_m) {
  Polygon points_m;
  for (std::size_t i = 0; i < border_m.size(); ++i) {
    const Segment side = geometry::side(border_m, i);
    const auto edges = std::lround(side.length_m() / resolution_m);
    for (long edge = 0; edge < edges; ++edge) {
      const double share = (static_cast<double>(edge) + 0.5) / static_cast<double>(edges);
      points_m.emplace_back(side.from_m + share * (side.to_m - side.from_m));
    }
  }
  return points_m;
}

class StraightOutline {
 public:
  StraightOutline(const RasterMap& map,
                  const std::vector<Segment>& walls,
                  const OutlineSideParams& params)
      : map_(map), walls_(merged_walls(walls, kSameWallM)), params_(params) {}

  Polygon of(const Polygon& border_m) {
    cut(edge_midpoints(border_m, map_.resolution_m()));
    do {
      while (sides_.size() > 3 && simplify_once()) {
      }
    } while (follow_walls());
    return corners();
  }

 private:
  /// What takes the place of some sides in a row.
  struct Replacement {
    std::size_t first = 0;
    std::size_t removed = 0;  ///< Between `first` and the side behind them.
    bool merges = false;      ///< The two around them become one, else they meet in a corner.
    double deviation_m = std::numeric_limits<double>::infinity();
  };

  const Side& side(std::size_t index) const { return sides_[index % sides_.size()]; }

  void cut(const Polygon& points_m) {
    const Polygon kept = geometry::SimplifiedRing(points_m, params_.cut_tolerance_m).polygon();
    if (kept.size() < 3) {
      return;
    }
    const auto begin = std::find(points_m.begin(), points_m.end(), kept.front());
    const auto first = static_cast<std::size_t>(begin - points_m.begin());
    std::size_t at = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Eigen::Vector2d& end_m = kept[(i + 1) % kept.size()];
      Side side;
      do {
        side.points_m.push_back(points_m[(first + at) % points_m.size()]);
        ++at;
      } while (points_m[(first + at) % points_m.size()] != end_m);
      side.points_m.push_back(end_m);
      place(side);
      sides_.push_back(std::move(side));
    }
  }

  /// Gives a side its line, from its points and the walls.
  void place(Side& side) const {
    side.line = line_through(side.points_m);
    side.is_known = is_known(side);
    const double length_m = (side.points_m.back() - side.points_m.front()).norm();
    follow_wall(side,
                length_m < params_.known_length_m ? kMaxMisalignmentOfPiece : kMaxMisalignment);
  }

  /// Pieces that are too ragged for a wall may have become a side that follows it. Whether any has.
  bool follow_walls() {
    bool any = false;
    for (Side& side : sides_) {
      if (!side.follows_wall) {
        follow_wall(side, kMaxMisalignment);
        any = any || side.follows_wall;
      }
    }
    return any;
  }

  /// Gives a side the line of the nearest wall that it can follow, if there is one.
  void follow_wall(Side& side, double max_misalignment) const {
    double nearest_m = params_.wall_distance_m;
    for (const MergedWall& wall : walls_) {
      const double misalignment =
          std::abs(geometry::cross(wall.line.direction, side.line.direction));
      if (wall.line.direction.dot(side.line.direction) <= 0.0 || misalignment > max_misalignment ||
          gap_m(wall, side) > params_.wall_gap_m) {
        continue;
      }
      if (const double distance_m = mean_distance_m(wall.line, side.points_m);
          distance_m < nearest_m) {
        nearest_m = distance_m;
        side.line = wall.line;
        side.follows_wall = true;
        side.is_known = true;
      }
    }
  }

  static double mean_distance_m(const DirectedLine& line,
                                const std::vector<Eigen::Vector2d>& points_m) {
    double sum_m = 0.0;
    for (const Eigen::Vector2d& point_m : points_m) {
      sum_m += std::abs(line.left_m(point_m));
    }
    return sum_m / static_cast<double>(points_m.size());
  }

  /// From the side to the nearest fitted part of the wall, along it.
  static double gap_m(const MergedWall& wall, const Side& side) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Segment& piece : wall.pieces) {
      for (const Eigen::Vector2d& point_m : side.points_m) {
        nearest_m = std::min(nearest_m, geometry::distance_m(piece, point_m));
      }
    }
    return nearest_m;
  }

  bool is_known(const Side& side) const {
    if ((side.points_m.back() - side.points_m.front()).norm() < params_.known_length_m) {
      return false;
    }
    const Eigen::Vector2d right = -geometry::perpendicular(side.line.direction);
    const auto backed = std::count_if(
        side.points_m.begin(), side.points_m.end(), [&](const Eigen::Vector2d& point_m) {
          return is_occupied(point_m + 0.75 * map_.resolution_m() * right) ||
                 is_occupied(point_m + 1.5 * map_.resolution_m() * right);
        });
    return 2 * static_cast<std::size_t>(backed) > side.points_m.size();
  }

  bool is_occupied(const Eigen::Vector2d& point_m) const {
    return map_.state(map_.cell_at(point_m)) == CellState::kOccupied;
  }

  /// Where two sides meet in a corner; empty where they are parallel, or would have to turn back.
  std::optional<Eigen::Vector2d> corner(const Side& before, const Side& after) const {
    const double turn = geometry::cross(before.line.direction, after.line.direction);
    if (std::abs(turn) < std::sin(params_.min_turn_rad)) {
      return std::nullopt;
    }
    return before.line.crossing(after.line);
  }

  /// The corners between a side and the next one: where they cross, or a step.
  std::vector<Eigen::Vector2d> joint(const Side& before, const Side& after) const {
    const Eigen::Vector2d border_m = 0.5 * (before.points_m.back() + after.points_m.front());
    // The direction of a side that is not known may be so far off that its corner is anywhere.
    const double reach_m =
        2.0 * (before.is_known && after.is_known ? params_.bridged_m : params_.detail_m);
    if (const auto corner_m = corner(before, after);
        corner_m && (*corner_m - border_m).norm() <= reach_m) {
      return {*corner_m};
    }
    const Eigen::Vector2d from_m = before.line.foot_of(border_m);
    const Eigen::Vector2d to_m = after.line.foot_of(border_m);
    if ((to_m - from_m).norm() < kMinSideM) {
      return {0.5 * (from_m + to_m)};
    }
    return {from_m, to_m};
  }

  Polygon corners() const {
    Polygon polygon;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      for (const Eigen::Vector2d& corner_m : joint(sides_[i], side(i + 1))) {
        polygon.push_back(corner_m);
      }
    }
    return polygon;
  }

  /// The points of all sides between two, and of the second if they are merged.
  std::vector<Eigen::Vector2d> points_between(std::size_t first, std::size_t last) const {
    std::vector<Eigen::Vector2d> points_m;
    for (std::size_t i = first; i < last; ++i) {
      points_m.insert(points_m.end(), side(i).points_m.begin(), side(i).points_m.end());
    }
    return points_m;
  }

  /// The line of two sides that become one: a wall's before a border's, the longer one's before the
  /// other's; of two borders a new fit.
  DirectedLine merged_line(const Side& first, const Side& second) const {
    if (first.follows_wall != second.follows_wall) {
      return first.follows_wall ? first.line : second.line;
    }
    if (!first.follows_wall) {
      std::vector<Eigen::Vector2d> points_m = first.points_m;
      points_m.insert(points_m.end(), second.points_m.begin(), second.points_m.end());
      return line_through(points_m);
    }
    return first.points_m.size() >= second.points_m.size() ? first.line : second.line;
  }

  static double deviation_m(const std::vector<Eigen::Vector2d>& points_m,
                            const std::vector<Segment>& chain) {
    double max_m = 0.0;
    for (const Eigen::Vector2d& point_m : points_m) {
      max_m = std::max(max_m, (nearest_on(chain, point_m) - point_m).norm());
    }
    return max_m;
  }

  static Eigen::Vector2d nearest_on(const std::vector<Segment>& chain,
                                    const Eigen::Vector2d& point_m) {
    Eigen::Vector2d nearest_m = geometry::nearest_point(chain.front(), point_m);
    for (const Segment& piece : chain) {
      const Eigen::Vector2d on_piece_m = geometry::nearest_point(piece, point_m);
      if ((on_piece_m - point_m).norm() < (nearest_m - point_m).norm()) {
        nearest_m = on_piece_m;
      }
    }
    return nearest_m;
  }

  /// Whether all between the border and the chain that takes its place is unknown.
  bool bridges_unknown(const std::vector<Eigen::Vector2d>& points_m,
                       const std::vector<Segment>& chain) const {
    const double step_m = 0.5 * map_.resolution_m();
    return std::all_of(points_m.begin(), points_m.end(), [&](const Eigen::Vector2d& point_m) {
      const Eigen::Vector2d offset_m = nearest_on(chain, point_m) - point_m;
      // The border's own cell, and those that the wall itself occupies, are left out.
      const double length_m = offset_m.norm() - params_.detail_m;
      for (double at_m = 1.5 * step_m; at_m < length_m; at_m += step_m) {
        if (map_.state(map_.cell_at(point_m + at_m * offset_m.normalized())) !=
            CellState::kUnknown) {
          return false;
        }
      }
      return true;
    });
  }

  Replacement corner_for(std::size_t first, std::size_t removed) const {
    const Side& before = side(first);
    const Side& after = side(first + removed + 1);
    const auto corner_m = corner(before, after);
    if (removed == 0 || !corner_m) {
      return {};
    }
    const Eigen::Vector2d start_m = joint(side(first + sides_.size() - 1), before).back();
    const Eigen::Vector2d end_m = joint(after, side(first + removed + 2)).front();
    if (before.line.direction.dot(*corner_m - start_m) < kMinSideM ||
        after.line.direction.dot(end_m - *corner_m) < kMinSideM) {
      return {};
    }
    const auto points_m = points_between(first + 1, first + removed + 1);
    const std::vector<Segment> chain{{start_m, *corner_m}, {*corner_m, end_m}};
    return judged({first, removed, false}, points_m, chain);
  }

  Replacement merger_for(std::size_t first, std::size_t removed) const {
    const Side& before = side(first);
    const Side& after = side(first + removed + 1);
    const auto& [forward, next] = std::pair(before.line.direction, after.line.direction);
    if (forward.dot(next) <= 0.0 ||
        std::abs(geometry::cross(forward, next)) > std::sin(params_.min_turn_rad)) {
      return {};
    }
    const DirectedLine line = merged_line(before, after);
    const auto points_m = points_between(first, first + removed + 2);
    const std::vector<Segment> chain{
        {line.foot_of(points_m.front()), line.foot_of(points_m.back())}};
    return judged({first, removed, true}, points_m, chain);
  }

  /// With its deviation, which stays infinite where it would change more than detail.
  Replacement judged(Replacement replacement,
                     const std::vector<Eigen::Vector2d>& points_m,
                     const std::vector<Segment>& chain) const {
    const double max_m = deviation_m(points_m, chain);
    const bool are_known = side(replacement.first).is_known &&
                           side(replacement.first + replacement.removed + 1).is_known;
    if (max_m <= params_.detail_m ||
        (are_known && max_m <= params_.bridged_m && bridges_unknown(points_m, chain))) {
      replacement.deviation_m = max_m;
    }
    return replacement;
  }

  bool simplify_once() {
    Replacement best;
    for (std::size_t first = 0; first < sides_.size(); ++first) {
      for (std::size_t removed = 0; removed <= kMaxRemoved && removed + 4 <= sides_.size();
           ++removed) {
        for (const Replacement& replacement :
             {corner_for(first, removed), merger_for(first, removed)}) {
          if (replacement.deviation_m < best.deviation_m) {
            best = replacement;
          }
        }
      }
    }
    if (!std::isfinite(best.deviation_m)) {
      return false;
    }
    apply(best);
    return true;
  }

  void apply(const Replacement& replacement) {
    std::rotate(sides_.begin(),
                sides_.begin() + static_cast<std::ptrdiff_t>(replacement.first),
                sides_.end());
    const std::size_t last = replacement.removed + 1;
    if (replacement.merges) {
      Side& merged = sides_.front();
      merged.line = merged_line(merged, sides_[last]);
      merged.points_m = points_between(0, last + 1);
      merged.follows_wall |= sides_[last].follows_wall;
      merged.is_known |= sides_[last].is_known;
    }
    sides_.erase(sides_.begin() + 1,
                 sides_.begin() + static_cast<std::ptrdiff_t>(last + (replacement.merges ? 1 : 0)));
  }

  const RasterMap& map_;
  std::vector<MergedWall> walls_;
  OutlineSideParams params_;
  std::vector<Side> sides_;
};

}  // namespace

Polygon straight_outline(const Polygon& border_m,
                         const RasterMap& map,
                         const std::vector<Segment>& walls,
                         const OutlineSideParams& params) {
  return StraightOutline(map, walls, params).of(border_m);
}

}  // namespace echomap::mapping
