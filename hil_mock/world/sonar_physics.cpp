// SPDX-License-Identifier: MIT
#include "hil_mock/world/sonar_physics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hil_mock/world/ray_cast.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::world {
namespace {

/// Nothing off the axis by more than this many half angles is heard (chance below 2 %).
constexpr double kFanHalfAngles = 1.4;
/// The beam falls from 88 to 12 % over 0.4 half angles.
constexpr double kBeamEdge = 0.1;
constexpr double kRayStepRad = geometry::radians(0.5);
/// A wall's answer falls from 88 to 12 % over 8 degrees of incidence.
constexpr double kIncidenceEdgeRad = geometry::radians(2.0);
/// A pane is flat to far less than the 8.6 mm of a wave: but for the spread of a transducer's own
/// field nothing comes back that is not met straight on.
constexpr double kGlassLimitRad = geometry::radians(4.0);
/// Returns weaker than this are left out.
constexpr double kMinStrength = 1e-3;

double fall_off(double distance_below, double width) {
  return 1.0 / (1.0 + std::exp(-distance_below / width));
}

}  // namespace

SonarPhysics::SonarPhysics(const FloorPlan& plan, const SonarParams& params)
    : plan_(plan), params_(params) {
  geometry::ParameterValidator("sonar")
      .positive("beam_half_angle_rad", params.beam_half_angle_rad)
      .below("beam_half_angle_rad", params.beam_half_angle_rad, 0.25 * std::numbers::pi)
      .at_least("min_range_m", params.min_range_m, 0.0)
      .above("max_range_m", params.max_range_m, params.min_range_m)
      .positive("speed_of_sound_m_per_s", params.speed_of_sound_m_per_s);
}

std::vector<SonarReturn> SonarPhysics::returns(const geometry::Pose2& T_world_sonar) const {
  std::vector<SonarReturn> found;
  const int rays =
      static_cast<int>(std::ceil(kFanHalfAngles * params_.beam_half_angle_rad / kRayStepRad));
  for (int i = -rays; i <= rays; ++i) {
    const double off_axis_rad = i * kRayStepRad;
    const double bearing_rad = T_world_sonar.heading_rad() + off_axis_rad;
    const Eigen::Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
    add_ray(T_world_sonar.position_m(), direction, beam_strength(off_axis_rad), found);
  }
  for (const Corner& corner : plan_.corners()) {
    add_corner(T_world_sonar, corner, found);
  }
  return found;
}

std::optional<SonarReturn> SonarPhysics::first_return(const geometry::Pose2& T_world_sonar,
                                                      double threshold) const {
  std::optional<SonarReturn> first;
  for (const SonarReturn& candidate : returns(T_world_sonar)) {
    if (candidate.strength > threshold && (!first || candidate.range_m < first->range_m)) {
      first = candidate;
    }
  }
  return first;
}

std::optional<double> SonarPhysics::ping_m(const geometry::Pose2& T_world_sonar,
                                           NoiseStream& noise) const {
  const double threshold = noise.uniform();
  const double error_m = params_.range_noise_m * noise.normal();
  const auto first = first_return(T_world_sonar, threshold);
  if (!first) {
    return std::nullopt;
  }
  return std::max(first->range_m + error_m, params_.min_range_m);
}

double SonarPhysics::beam_strength(double off_axis_rad) const {
  const double beam_half_angles = std::abs(off_axis_rad) / params_.beam_half_angle_rad;
  return beam_half_angles > kFanHalfAngles ? 0.0 : fall_off(1.0 - beam_half_angles, kBeamEdge);
}

double SonarPhysics::wall_strength(double incidence_rad, Material material) const {
  const double wall_limit_rad =
      material == Material::kRough ? params_.rough_limit_rad : params_.smooth_limit_rad;
  const double limit_rad =
      material == Material::kGlass ? std::min(kGlassLimitRad, wall_limit_rad) : wall_limit_rad;
  return fall_off(limit_rad - incidence_rad, kIncidenceEdgeRad);
}

void SonarPhysics::add_ray(const Eigen::Vector2d& origin_m,
                           const Eigen::Vector2d& direction,
                           double beam,
                           std::vector<SonarReturn>& found) const {
  const auto hit = cast_ray(plan_, origin_m, direction);
  if (!hit) {
    return;
  }
  const double answer = wall_strength(hit->incidence_rad, hit->wall->surface.material);
  add({hit->distance_m, beam * answer, ReturnKind::kWall}, found);
  if (hit->wall->surface.material == Material::kRough) {
    return;
  }
  const Eigen::Vector2d normal = left_normal(hit->wall->segment);
  const Eigen::Vector2d mirrored = direction - 2.0 * direction.dot(normal) * normal;
  const auto second = cast_ray(plan_, origin_m + hit->distance_m * direction, mirrored);
  if (second) {
    const double back = wall_strength(second->incidence_rad, second->wall->surface.material);
    add({hit->distance_m + second->distance_m,
         params_.ghost_strength * beam * back,
         ReturnKind::kGhost},
        found);
  }
}

void SonarPhysics::add_corner(const geometry::Pose2& T_world_sonar,
                              const Corner& corner,
                              std::vector<SonarReturn>& found) const {
  const Eigen::Vector2d corner_m = T_world_sonar.inverse() * corner.position_m;
  const double beam = beam_strength(std::atan2(corner_m.y(), corner_m.x()));
  if (beam == 0.0 || !sees(plan_, T_world_sonar.position_m(), corner.position_m)) {
    return;
  }
  const bool niche = corner.turn_rad > 0.0;
  const double sharpness = std::min(1.0, std::abs(corner.turn_rad) / (0.5 * std::numbers::pi));
  const double full = niche ? params_.niche_strength : params_.edge_strength;
  add({corner_m.norm(), full * sharpness * beam, niche ? ReturnKind::kNiche : ReturnKind::kEdge},
      found);
}

void SonarPhysics::add(const SonarReturn& candidate, std::vector<SonarReturn>& found) const {
  if (candidate.strength > kMinStrength && candidate.range_m >= params_.min_range_m &&
      candidate.range_m <= params_.max_range_m) {
    found.push_back(candidate);
  }
}

}  // namespace echomap::world
