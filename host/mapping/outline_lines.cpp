// SPDX-License-Identifier: MIT
#include "host/mapping/outline_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/polygon_simplification.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using geometry::Segment;

/// Pieces of wall whose ends are this near to one line are one wall.
constexpr double kSameWallM = 0.05;
/// Both ends of a border's side may be off its line by this much, so that its direction may be a
/// wall's.
constexpr double kSideEndM = 0.05;
constexpr double kSameWallRad = 0.05;
/// Around the end of a wall a border's mean direction is anything.
constexpr double kBehind = 0.3;

Eigen::Vector2d middle_of(const std::vector<BorderPoint>& points) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const BorderPoint& point : points) {
    sum_m += point.position_m;
  }
  return sum_m / static_cast<double>(points.size());
}

/// The border between neighbouring corners of its simplified ring; each has both of its corners.
std::vector<std::vector<BorderPoint>> cut(const std::vector<BorderPoint>& border,
                                          double tolerance_m) {
  geometry::Polygon ring_m;
  for (const BorderPoint& point : border) {
    ring_m.push_back(point.position_m);
  }
  const auto kept = geometry::SimplifiedRing(ring_m, tolerance_m).polygon();
  if (kept.size() < 3) {
    return {};
  }
  std::vector<std::vector<BorderPoint>> sides;
  auto at = static_cast<std::size_t>(std::find(ring_m.begin(), ring_m.end(), kept.front()) -
                                     ring_m.begin());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    std::vector<BorderPoint> side{border[at % border.size()]};
    while (ring_m[at % ring_m.size()] != kept[(i + 1) % kept.size()]) {
      ++at;
      side.push_back(border[at % border.size()]);
    }
    sides.push_back(std::move(side));
  }
  return sides;
}

bool is_mostly_occupied(const std::vector<BorderPoint>& side) {
  const auto occupied = std::count_if(
      side.begin(), side.end(), [](const BorderPoint& point) { return point.is_occupied; });
  return 2 * static_cast<std::size_t>(occupied) > side.size();
}

OutlineLine line_of(const std::vector<BorderPoint>& side, double cost_m) {
  std::vector<Eigen::Vector2d> points_m;
  points_m.reserve(side.size());
  for (const BorderPoint& point : side) {
    points_m.push_back(point.position_m);
  }
  // The corners may be points of the neighbours.
  if (points_m.size() > 3) {
    points_m.erase(points_m.begin());
    points_m.pop_back();
  }
  const DirectedLine line = line_through(points_m);
  return {line,
          {{line.foot_of(points_m.front()), line.foot_of(points_m.back())}},
          false,
          is_mostly_occupied(side),
          cost_m};
}

/// The same line, turned about the middle of its side.
OutlineLine turned(const OutlineLine& line,
                   const Eigen::Vector2d& middle_m,
                   const Eigen::Vector2d& direction,
                   double cost_m) {
  OutlineLine turned = line;
  turned.line = {middle_m, direction};
  for (Segment& piece : turned.pieces) {
    piece = {turned.line.foot_of(piece.from_m), turned.line.foot_of(piece.to_m)};
  }
  turned.cost_m = cost_m;
  return turned;
}

/// Parallel and at right angles to the walls, both ways, those of long walls first.
std::vector<Eigen::Vector2d> directions_of(const std::vector<MergedWall>& walls) {
  std::vector<Eigen::Vector2d> directions;
  for (const MergedWall& wall : walls) {
    const Eigen::Vector2d along = wall.line.direction;
    const bool is_known =
        std::any_of(directions.begin(), directions.end(), [&](const Eigen::Vector2d& known) {
          return known.dot(along) > std::cos(kSameWallRad);
        });
    if (!is_known) {
      const Eigen::Vector2d across = geometry::perpendicular(along);
      directions.insert(directions.end(), {along, across, -along, -across});
    }
  }
  return directions;
}

/// From a point of the line to where the line is known.
double gap_m(const OutlineLine& line, const Eigen::Vector2d& foot_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Segment& piece : line.pieces) {
    nearest_m = std::min(nearest_m, geometry::distance_m(piece, foot_m));
  }
  return nearest_m;
}

bool is_behind(const OutlineLine& line, const BorderPoint& point) {
  return point.outward.dot(geometry::perpendicular(line.line.direction)) > kBehind;
}

/// Whether a point may be of the back of cells that were drawn for that wall.
bool is_close_behind(const OutlineLine& line,
                     const BorderPoint& point,
                     const OutlineLineParams& params) {
  return is_behind(line, point) &&
         std::abs(line.line.left_m(point.position_m)) <= params.max_deviation_m &&
         gap_m(line, line.line.foot_of(point.position_m)) <= params.reach_m;
}

double misfit(const OutlineLine& line,
              const BorderPoint& point,
              const RasterMap& map,
              const OutlineLineParams& params) {
  const double left_m = line.line.left_m(point.position_m);
  const Eigen::Vector2d foot_m = line.line.foot_of(point.position_m);
  if (is_behind(line, point) || gap_m(line, foot_m) > params.reach_m) {
    return 1.0;
  }
  // The border of the cells is off the wall that they were drawn for by up to a cell.
  const double rounded_m = line.is_fitted ? map.resolution_m() : 0.0;
  const double deviation =
      std::max(0.0, std::abs(left_m) - rounded_m) / (params.max_deviation_m - rounded_m);
  const double share = std::min(1.0, deviation * deviation);
  if (point.is_occupied) {
    return share;
  }
  if (!line.is_wall) {
    return std::max(share, params.unknown_share);
  }
  const bool is_bridged = left_m > 0.0 && left_m <= params.bridged_m &&
                          is_unknown_up_to(map, point.position_m, foot_m, params.max_deviation_m);
  return is_bridged ? params.bridged_share : std::max(share, params.bridged_share);
}

}  // namespace

std::vector<OutlineLine> outline_lines(const std::vector<BorderPoint>& border,
                                       const std::vector<Segment>& walls,
                                       const OutlineLineParams& params) {
  std::vector<OutlineLine> lines;
  const auto merged = merged_walls(walls, kSameWallM);
  lines.reserve(merged.size());
  for (const MergedWall& wall : merged) {
    lines.push_back({wall.line, wall.pieces, true, true, 0.0});
  }
  const auto directions = directions_of(merged);
  for (const auto& side : cut(border, params.cut_tolerance_m)) {
    const OutlineLine own = line_of(side, params.own_direction_m);
    const double half_length_m = 0.5 * own.pieces.front().length_m();
    lines.push_back(own);
    for (const Eigen::Vector2d& direction : directions) {
      if (direction.dot(own.line.direction) > 0.0 &&
          half_length_m * std::abs(geometry::cross(direction, own.line.direction)) <= kSideEndM) {
        lines.push_back(turned(own, middle_of(side), direction, params.own_line_m));
      }
    }
  }
  return lines;
}

std::vector<double> misfits(const std::vector<OutlineLine>& lines,
                            const BorderPoint& point,
                            const RasterMap& map,
                            const OutlineLineParams& params) {
  std::vector<double> shares;
  bool is_before_wall = false;
  for (const OutlineLine& line : lines) {
    shares.push_back(misfit(line, point, map, params));
    is_before_wall = is_before_wall || (line.is_fitted && shares.back() < 1.0);
  }
  for (std::size_t i = 0; i < lines.size() && !is_before_wall; ++i) {
    if (lines[i].is_fitted && is_close_behind(lines[i], point, params)) {
      shares[i] = params.behind_share;
    }
  }
  return shares;
}

}  // namespace echomap::mapping
