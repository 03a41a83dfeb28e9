// SPDX-License-Identifier: MIT
#include "hil_mock/world/ir_switches.hpp"

#include <algorithm>
#include <cmath>

#include "hil_mock/world/ray_cast.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

constexpr double kFanStepRad = geometry::radians(1.0);

/// Whether a ray meets a wall that is bright enough within a reach to white paint.
bool lights_up(const FloorPlan& plan,
               const Eigen::Vector2d& from_m,
               double bearing_rad,
               double reach_m) {
  const auto hit = cast_ray(plan, from_m, {std::cos(bearing_rad), std::sin(bearing_rad)});
  return hit &&
         hit->distance_m <= reach_m * std::sqrt(light_back(hit->wall->surface, hit->incidence_rad) /
                                                kPaperReflectance);
}

bool own_beam_lights_up(const FloorPlan& plan,
                        const geometry::Pose2& T_world_robot,
                        const BeamDetectorParams& detector) {
  const Eigen::Vector2d from_m = T_world_robot * detector.mount_m;
  const int rays = static_cast<int>(std::floor(detector.own_beam_half_angle_rad / kFanStepRad));
  for (int i = -rays; i <= rays; ++i) {
    const double bearing_rad = T_world_robot.heading_rad() + i * kFanStepRad;
    if (lights_up(plan, from_m, bearing_rad, detector.own_beam_reach_m)) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool beam_reaches(const FloorPlan& plan, const VirtualWall& beam, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d offset_m = point_m - beam.origin_m;
  const double off_axis_rad =
      geometry::angle_between(beam.heading_rad, std::atan2(offset_m.y(), offset_m.x()));
  return offset_m.norm() <= beam.length_m && std::abs(off_axis_rad) <= beam.beam_half_angle_rad &&
         sees(plan, beam.origin_m, point_m);
}

bool beam_detected(const FloorPlan& plan,
                   const geometry::Pose2& T_world_robot,
                   const BeamDetectorParams& detector) {
  const Eigen::Vector2d at_m = T_world_robot * detector.mount_m;
  const bool from_room = std::any_of(
      plan.virtual_walls().begin(), plan.virtual_walls().end(), [&](const VirtualWall& beam) {
        return beam_reaches(plan, beam, at_m);
      });
  return from_room ||
         (detector.own_beam_reach_m > 0.0 && own_beam_lights_up(plan, T_world_robot, detector));
}

bool wall_detected(const FloorPlan& plan,
                   const geometry::Pose2& T_world_robot,
                   const WallSensorParams& sensor) {
  const geometry::Pose2 T_world_sensor = T_world_robot * sensor.T_robot_sensor;
  return lights_up(plan, T_world_sensor.position_m(), T_world_sensor.heading_rad(), sensor.reach_m);
}

}  // namespace echomap::world
