// SPDX-License-Identifier: MIT
#include "host/diagnosis/placed_log.hpp"

#include <cmath>

#include "host/geometry/pose2.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::diagnosis {
namespace {

struct Place {
  geometry::Pose2 T_map_robot;
  double travelled_m = 0.0;
};

/// Places what a robot of some errors has heard.
class Placer {
 public:
  Placer(const sensors::RobotGeometry& robot, const RobotErrors& errors)
      : robot_(robot), errors_(errors), T_robot_axis_(robot.sonar_x_m, robot.sonar_y_m, 0.0) {}

  Place moved(const Place& from, const WheelStep& step) const {
    const double left_m = errors_.left_scale * step.left_m;
    const double right_m = errors_.right_scale * step.right_m;
    const double turn_rad = (right_m - left_m) / (errors_.track_scale * robot_.track_m);
    return {from.T_map_robot * sensors::arc_step(0.5 * (left_m + right_m), turn_rad),
            from.travelled_m + 0.5 * (std::abs(step.left_m) + std::abs(step.right_m))};
  }

  PlacedStand placed(const Stand& stand, const Place& at) const {
    const geometry::Pose2 T_map_axis = at.T_map_robot * T_robot_axis_;
    PlacedStand placed{{}, at.travelled_m, stand.piece};
    placed.surfaces.reserve(stand.surfaces.size());
    for (const mapping::SonarSurface& surface : stand.surfaces) {
      const Eigen::Vector2d direction = direction_of(surface.bearing_rad, T_map_axis);
      placed.surfaces.push_back(
          {T_map_axis.position_m() + errors_.range_scale * surface.range_m * direction,
           direction,
           surface.half_length_m > 0.0,
           surface.readings});
    }
    return placed;
  }

  PlacedPing placed(const RollingPing& ping, const Place& at) const {
    const geometry::Pose2 T_map_axis = at.T_map_robot * T_robot_axis_;
    return {T_map_axis.position_m(),
            direction_of(ping.bearing_rad, T_map_axis),
            errors_.range_scale * ping.range_m,
            at.travelled_m,
            ping.piece};
  }

 private:
  Eigen::Vector2d direction_of(double bearing_rad, const geometry::Pose2& T_map_axis) const {
    return geometry::unit_vector(T_map_axis.heading_rad() + errors_.pan_offset_rad +
                                 errors_.pan_scale * bearing_rad);
  }

  const sensors::RobotGeometry& robot_;
  const RobotErrors& errors_;
  geometry::Pose2 T_robot_axis_;
};

}  // namespace

PlacedLog place(const StandLog& log, const RobotErrors& errors) {
  const Placer placer(log.robot(), errors);
  std::vector<Place> places{Place()};
  places.reserve(log.steps().size() + 1);
  for (const WheelStep& step : log.steps()) {
    places.push_back(placer.moved(places.back(), step));
  }
  PlacedLog placed;
  placed.stands.reserve(log.stands().size());
  for (const Stand& stand : log.stands()) {
    placed.stands.push_back(placer.placed(stand, places[stand.steps]));
  }
  placed.pings.reserve(log.rolling_pings().size());
  for (const RollingPing& ping : log.rolling_pings()) {
    placed.pings.push_back(placer.placed(ping, placer.moved(places[ping.steps], ping.rolled)));
  }
  return placed;
}

}  // namespace echomap::diagnosis
