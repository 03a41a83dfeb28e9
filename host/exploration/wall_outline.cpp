// SPDX-License-Identifier: MIT
#include "host/exploration/wall_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/line_extraction.hpp"

namespace echomap::exploration {

namespace {

using geometry::Polygon;
using mapping::FittedLine;
using Places = std::vector<Eigen::Vector2d>;

constexpr double kPointStddevM = 0.01;
/// Ahead of where a walk was noticed to have come round it may come nearer to its beginning still.
constexpr double kLookOnM = 1.0;

void validate(const WallOutlineParams& params) {
  geometry::ParameterValidator("wall outline")
      .positive("straight_m", params.straight_m)
      .positive("min_wall_m", params.min_wall_m)
      .positive("min_turn_rad", params.min_turn_rad)
      .positive("corner_reach_m", params.corner_reach_m);
}

/// The way of one round: to where the walk came nearest to its beginning.
double one_round_m(const std::vector<WallStep>& steps, double round_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  double travelled_m = round_m;
  for (const WallStep& step : steps) {
    const double away_m =
        (step.T_map_robot.position_m() - steps.front().T_map_robot.position_m()).norm();
    if (step.travelled_m >= round_m && step.travelled_m <= round_m + kLookOnM &&
        away_m < nearest_m) {
      nearest_m = away_m;
      travelled_m = step.travelled_m;
    }
  }
  return travelled_m;
}

/// In order, beginning in the corner that is farthest from the middle.
Places ring_of(const std::vector<WallPoint>& points, double end_m) {
  Places ring;
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  for (const WallPoint& point : points) {
    if (point.travelled_m <= end_m) {
      ring.push_back(point.place_m);
      middle_m += point.place_m;
    }
  }
  middle_m /= static_cast<double>(std::max<std::size_t>(ring.size(), 1));
  const auto farthest =
      std::max_element(ring.begin(), ring.end(), [&](const auto& a, const auto& b) {
        return (a - middle_m).squaredNorm() < (b - middle_m).squaredNorm();
      });
  std::rotate(ring.begin(), farthest, ring.end());
  return ring;
}

/// Whether most of a straight piece was seen only at its ends: it lies between two walls.
bool is_gap(const FittedLine& wall, const Places& ring, double straight_m) {
  const double length_m = wall.segment.length_m();
  const Eigen::Vector2d ahead = (wall.segment.to_m - wall.segment.from_m) / length_m;
  std::vector<double> seen_m{0.0, length_m};
  for (const Eigen::Vector2d& place_m : ring) {
    if (geometry::distance_m(wall.segment, place_m) <= straight_m) {
      seen_m.push_back(std::clamp(ahead.dot(place_m - wall.segment.from_m), 0.0, length_m));
    }
  }
  std::sort(seen_m.begin(), seen_m.end());
  double max_m = 0.0;
  for (std::size_t i = 1; i < seen_m.size(); ++i) {
    max_m = std::max(max_m, seen_m[i] - seen_m[i - 1]);
  }
  return max_m > 0.5 * length_m;
}

double bearing_rad(const FittedLine& wall) {
  const Eigen::Vector2d offset_m = wall.segment.to_m - wall.segment.from_m;
  return std::atan2(offset_m.y(), offset_m.x());
}

double turn_rad(const FittedLine& from, const FittedLine& to) {
  return geometry::angle_between(bearing_rad(from), bearing_rad(to));
}

/// Two walls that may be one: along the longer of them, from the one's beginning to the other's
/// end.
FittedLine joined(const FittedLine& first, const FittedLine& second) {
  FittedLine wall = first.segment.length_m() > second.segment.length_m() ? first : second;
  const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
  const auto foot = [&](const Eigen::Vector2d& place_m) -> Eigen::Vector2d {
    return place_m - (normal.dot(place_m) - wall.offset_m) * normal;
  };
  wall.segment = {foot(first.segment.from_m), foot(second.segment.to_m)};
  return wall;
}

bool are_one(const FittedLine& first, const FittedLine& second, const WallOutlineParams& params) {
  if (std::abs(turn_rad(first, second)) > params.min_turn_rad) {
    return false;
  }
  const FittedLine wall = joined(first, second);
  const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
  const auto is_near = [&](const Eigen::Vector2d& place_m) {
    return std::abs(normal.dot(place_m) - wall.offset_m) <= params.straight_m;
  };
  return is_near(first.segment.from_m) && is_near(first.segment.to_m) &&
         is_near(second.segment.from_m) && is_near(second.segment.to_m);
}

/// Neighbours in a ring that are one wall are joined.
void join(std::vector<FittedLine>& walls, const WallOutlineParams& params) {
  for (std::size_t i = 0; i < walls.size() && walls.size() > 3;) {
    const std::size_t next = (i + 1) % walls.size();
    if (are_one(walls[i], walls[next], params)) {
      walls[i] = joined(walls[i], walls[next]);
      walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(next));
      i = 0;
    } else {
      ++i;
    }
  }
}

/// Where the walls meet; where they do not, both of their ends.
Polygon corners_of(const std::vector<FittedLine>& walls, const WallOutlineParams& params) {
  mapping::WallCornerParams corner_params;
  corner_params.reach_m = params.corner_reach_m;
  corner_params.min_turn_rad = params.min_turn_rad;
  const auto corners = mapping::find_corners(walls, true, corner_params);
  Polygon outline;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto corner = std::find_if(
        corners.begin(), corners.end(), [&](const auto& one) { return one.line == i; });
    if (corner != corners.end()) {
      outline.push_back(corner->position_m);
    } else {
      outline.push_back(walls[i].segment.to_m);
      outline.push_back(walls[(i + 1) % walls.size()].segment.from_m);
    }
  }
  return outline;
}

}  // namespace

Polygon wall_outline(const std::vector<WallStep>& steps,
                     double round_m,
                     const geometry::Pose2& T_robot_sensor,
                     const WallOutlineParams& params) {
  validate(params);
  if (steps.empty()) {
    return {};
  }
  mapping::LineExtractionParams straight;
  straight.split_distance_m = params.straight_m;
  straight.max_gap_m = std::numeric_limits<double>::infinity();
  straight.point_stddev_m = kPointStddevM;
  straight.min_length_m = params.min_wall_m;
  const Places ring = ring_of(wall_points(steps, T_robot_sensor), one_round_m(steps, round_m));
  auto walls = mapping::extract_lines(ring, straight);
  std::erase_if(walls,
                [&](const FittedLine& wall) { return is_gap(wall, ring, params.straight_m); });
  join(walls, params);
  const Polygon outline = corners_of(walls, params);
  return geometry::polygon_fault(outline) ? Polygon{} : outline;
}

}  // namespace echomap::exploration
