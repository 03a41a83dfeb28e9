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

namespace echomap::mapping {
namespace {

constexpr double kNowhereM = std::numeric_limits<double>::infinity();

geometry::Segment prolonged(const geometry::Segment& wall, double beyond_ends_m) {
  const Eigen::Vector2d beyond_m = beyond_ends_m * (wall.to_m - wall.from_m).normalized();
  return {wall.from_m - beyond_m, wall.to_m + beyond_m};
}

double bearing_to_rad(const Eigen::Vector2d& offset_m) {
  return std::atan2(offset_m.y(), offset_m.x());
}

/// The nearest of what stops agree on, by bearing.
struct Nearest {
  BearingProfile any_m{kNowhereM};
  /// Of what turns its face to the stop: nobody sees a wall from behind.
  BearingProfile facing_m{kNowhereM};

  void take(std::size_t index, double distance_m, bool is_facing) {
    any_m[index] = std::min(any_m[index], distance_m);
    facing_m[index] = is_facing ? std::min(facing_m[index], distance_m) : facing_m[index];
  }
};

void look_at(const geometry::Segment& wall, const Eigen::Vector2d& from_m, Nearest& nearest) {
  const bool is_facing = geometry::left_normal(wall).dot(from_m - wall.from_m) > 0.0;
  const double first_rad = bearing_to_rad(wall.from_m - from_m);
  const double half_rad =
      0.5 * geometry::angle_between(first_rad, bearing_to_rad(wall.to_m - from_m));
  BearingProfile::visit_about(first_rad + half_rad, std::abs(half_rad), [&](std::size_t i) {
    const auto distance_m = geometry::ray_distance_m(
        from_m, geometry::unit_vector(BearingProfile::bearing_rad(i)), wall);
    nearest.take(i, distance_m.value_or(kNowhereM), is_facing);
  });
}

/// Takes the near side of a circle.
void look_at(const FittedCircle& circle, const Eigen::Vector2d& from_m, Nearest& nearest) {
  const Eigen::Vector2d offset_m = circle.center_m - from_m;
  const double distance_m = offset_m.norm();
  const double half_rad =
      distance_m > circle.radius_m ? std::asin(circle.radius_m / distance_m) : std::numbers::pi;
  BearingProfile::visit_about(bearing_to_rad(offset_m), half_rad, [&](std::size_t i) {
    const Eigen::Vector2d direction = geometry::unit_vector(BearingProfile::bearing_rad(i));
    const double along_m = direction.dot(offset_m);
    const double half_chord2_m2 =
        circle.radius_m * circle.radius_m - (offset_m - along_m * direction).squaredNorm();
    const double near_m = along_m - std::sqrt(std::max(0.0, half_chord2_m2));
    nearest.take(i, std::max(0.0, near_m), true);
  });
}

/// Whether no surface is within `half_rad` of a direction, and there is none in which nobody has
/// listened: 1, or else 0.
BearingProfile open_all_about(const ScanSurfaces& scan,
                              const BearingProfile& heard_m,
                              double half_rad) {
  BearingProfile is_open(1.0);
  const auto close_about = [&](double bearing_rad) {
    BearingProfile::visit_about(bearing_rad, half_rad, [&](std::size_t i) { is_open[i] = 0.0; });
  };
  for (const SonarSurface& surface : scan.surfaces) {
    close_about(surface.bearing_rad);
  }
  for (std::size_t i = 0; i < BearingProfile::kBearings; ++i) {
    if (heard_m[i] == 0.0) {
      close_about(BearingProfile::bearing_rad(i));
    }
  }
  return is_open;
}

}  // namespace

StopFloor::StopFloor(const ScanSurfaces& scan,
                     const SonarSurfaceParams& beam,
                     const StopFloorParams& params)
    : params_(params),
      nearer_by_slant_(std::cos(beam.beam_edge * beam.beam_half_angle_rad)),
      depth_tolerance_m_(beam.depth_tolerance_m),
      center_m_(scan.center_m),
      heard_m_(heard_within(scan.looks, params.looks_half_angle_rad)),
      alone_m_(heard_within(scan.looks, params.echo_half_angle_rad)) {
  const ScanOutline outline(scan, params.max_gap_rad);
  const BearingProfile is_open = open_all_about(scan, heard_m_, params.open_half_angle_rad);
  const double open_m = params.open_share * params.max_range_m;
  for (std::size_t i = 0; i < BearingProfile::kBearings; ++i) {
    const double outline_m = outline.range_m(BearingProfile::bearing_rad(i)) - params.margin_m;
    const double end_m = is_open[i] > 0.0 ? open_m : outline_m;
    alone_m_[i] = std::max(0.0, std::min(end_m, alone_m_[i] - params.echo_margin_m));
  }
}

FloorReach StopFloor::reach(const SonarFeatures& features) const {
  Nearest nearest;
  for (const geometry::Segment& wall : features.walls) {
    if (geometry::distance_m(wall, center_m_) <= params_.max_range_m) {
      look_at(prolonged(wall, params_.hidden_beyond_ends_m), center_m_, nearest);
    }
  }
  for (const FittedCircle& circle : features.circles) {
    const bool is_round = circle.radius_m > 0.0;  // A post may be the edge of anything.
    if (is_round && (circle.center_m - center_m_).norm() - circle.radius_m <= params_.max_range_m) {
      look_at(circle, center_m_, nearest);
    }
  }
  FloorReach reach;
  for (std::size_t i = 0; i < BearingProfile::kBearings; ++i) {
    const double any_m = nearest.any_m[i];
    const bool is_faced =
        any_m < kNowhereM && nearest.facing_m[i] <= any_m + params_.wall_thickness_m;
    const bool is_clear = is_faced && heard_m_[i] >= nearer_by_slant_ * any_m - depth_tolerance_m_;
    const bool is_heard = is_clear && heard_m_[i] <= any_m + depth_tolerance_m_;
    const double max_m = std::min(any_m, params_.max_range_m);
    reach.heard_m[i] = std::min(is_heard ? any_m : alone_m_[i], max_m);
    reach.silent_m[i] = std::min(is_clear ? any_m : alone_m_[i], max_m);
  }
  return reach;
}

}  // namespace echomap::mapping
