// SPDX-License-Identifier: MIT
#include "host/mapping/stop_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/scan_outline.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {
namespace {

constexpr double kNowhereM = std::numeric_limits<double>::infinity();
/// Half a degree: a third of a cell at 2 m.
constexpr std::size_t kBearings = 720;
constexpr double kBearingStepRad = 2.0 * std::numbers::pi / kBearings;

std::vector<geometry::Segment> segments_of(const std::vector<MatchedWall>& walls,
                                           double beyond_ends_m) {
  std::vector<geometry::Segment> segments;
  for (const MatchedWall& wall : walls) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    const Eigen::Vector2d foot_m = wall.offset_m * normal;
    for (const auto& piece : wall.pieces) {
      segments.push_back({foot_m + (piece.from_m - beyond_ends_m) * along,
                          foot_m + (piece.to_m + beyond_ends_m) * along});
    }
  }
  return segments;
}

/// To the nearest wall in a direction.
double wall_m(const std::vector<geometry::Segment>& walls,
              const Eigen::Vector2d& from_m,
              double bearing_rad) {
  double nearest_m = kNowhereM;
  for (const auto& wall : walls) {
    const auto distance =
        geometry::ray_distance_m(from_m, geometry::unit_vector(bearing_rad), wall);
    nearest_m = std::min(nearest_m, distance.value_or(kNowhereM));
  }
  return nearest_m;
}

/// The nearest that was heard about a direction: infinity for silence, 0 where nobody has listened.
double heard_m(const std::vector<sensors::Beam>& looks,
               double bearing_rad,
               double beam_half_angle_rad) {
  double nearest_m = kNowhereM;
  bool listened = false;
  for (const sensors::Beam& look : looks) {
    if (std::abs(geometry::angle_between(bearing_rad, look.bearing_rad)) <= beam_half_angle_rad) {
      listened = true;
      nearest_m = std::min(nearest_m, look.range_m.value_or(kNowhereM));
    }
  }
  return listened ? nearest_m : 0.0;
}

}  // namespace

StopFloor::StopFloor(const ScanSurfaces& scan,
                     const std::vector<MatchedWall>& walls,
                     const SonarSurfaceParams& beam,
                     const StopFloorParams& params)
    : reaches_m_(kBearings) {
  const auto segments = segments_of(walls, params.hidden_beyond_ends_m);
  const ScanOutline outline(scan, params.max_gap_rad);
  const double nearer_by_slant = std::cos(beam.beam_edge * beam.beam_half_angle_rad);
  for (std::size_t i = 0; i < kBearings; ++i) {
    const double bearing_rad = -std::numbers::pi + (static_cast<double>(i) + 0.5) * kBearingStepRad;
    const double to_wall_m = wall_m(segments, scan.center_m, bearing_rad);
    const double nearer_m = nearer_by_slant * to_wall_m - beam.depth_tolerance_m;
    const bool up_to_wall =
        to_wall_m < kNowhereM &&
        heard_m(scan.looks, bearing_rad, params.looks_half_angle_rad) >= nearer_m;
    const double outline_m = outline.range_m(bearing_rad) - params.margin_m;
    reaches_m_[i] = up_to_wall ? to_wall_m : std::max(0.0, std::min(outline_m, to_wall_m));
  }
}

double StopFloor::reach_m(double bearing_rad) const {
  const auto index = static_cast<std::size_t>((bearing_rad + std::numbers::pi) / kBearingStepRad);
  return reaches_m_[std::min(index, kBearings - 1)];
}

double StopFloor::max_m() const { return *std::max_element(reaches_m_.begin(), reaches_m_.end()); }

}  // namespace echomap::mapping
