// SPDX-License-Identifier: MIT
#include "host/papers/laser_hall.hpp"

#include <algorithm>
#include <cmath>

#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/ray_cast.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/papers/bounce_drive.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr int kLaserBeams = 180;
constexpr double kLaserRangeM = 30.0;
constexpr double kRangeStddevM = 0.02;
constexpr int kHallRounds = 3;
constexpr double kLaserStepM = 0.2;
constexpr double kLaserStepRad = 0.25;
/// The robot only turns where its next goal is farther to the side.
constexpr double kMaxDriveRad = 0.8;
constexpr double kGoalRadiusM = 0.3;

/// Around the hall along its walls, and then between its pillars.
const std::vector<Eigen::Vector2d> goals_of_round = {{8.8, 1.2},
                                                     {8.8, 8.8},
                                                     {1.2, 8.8},
                                                     {1.2, 3.7},
                                                     {6.3, 3.7},
                                                     {6.3, 6.3},
                                                     {3.7, 6.3},
                                                     {3.7, 1.2},
                                                     {1.2, 1.2}};

class LaserRobot {
 public:
  LaserRobot(const world::FloorPlan& hall, std::uint32_t seed)
      : hall_(hall),
        wheel_noise_(seed, world::NoisePurpose::kBody),
        laser_noise_(seed, world::NoisePurpose::kRange0),
        errors_(body_.drive, wheel_noise_) {
    add_scan();
  }

  void drive_to(const Eigen::Vector2d& goal_m) {
    Eigen::Vector2d offset_m = goal_m - T_world_robot_.position_m();
    while (offset_m.norm() > kGoalRadiusM) {
      const double bearing_rad = geometry::angle_between(T_world_robot_.heading_rad(),
                                                         std::atan2(offset_m.y(), offset_m.x()));
      step(std::clamp(bearing_rad, -kLaserStepRad, kLaserStepRad),
           std::abs(bearing_rad) < kMaxDriveRad ? kLaserStepM : 0.0);
      offset_m = goal_m - T_world_robot_.position_m();
    }
  }
  const LaserDrive& drive() const { return drive_; }

 private:
  /// Along an arc: half of the turn before the drive, half after it.
  void step(double turn_rad, double drive_m) {
    T_world_robot_ = T_world_robot_ * Pose2(0.0, 0.0, 0.5 * turn_rad) * Pose2(drive_m, 0.0, 0.0) *
                     Pose2(0.0, 0.0, 0.5 * turn_rad);
    const Pose2 first = errors_.measured(0.5 * turn_rad, drive_m);
    drive_.records.emplace_back(
        datasets::OdometryStep{stamp_s(), first * errors_.measured(0.5 * turn_rad, 0.0)});
    add_scan();
  }
  void add_scan() {
    sensors::RangeScan scan;
    scan.stamp_s = stamp_s();
    scan.max_range_m = kLaserRangeM;
    scan.is_light = true;
    for (int i = 0; i < kLaserBeams; ++i) {
      const double bearing_rad = geometry::radians(i - 90.0);
      const auto hit =
          world::cast_ray(hall_,
                          T_world_robot_.position_m(),
                          geometry::unit_vector(T_world_robot_.heading_rad() + bearing_rad));
      const double noise_m = kRangeStddevM * laser_noise_.normal();
      scan.beams.push_back({bearing_rad,
                            hit ? sensors::returned_range_m(hit->distance_m + noise_m, kLaserRangeM)
                                : std::nullopt});
    }
    drive_.records.emplace_back(std::move(scan));
    drive_.T_start_scans.push_back(hall_.T_world_start().inverse() * T_world_robot_);
  }
  double stamp_s() const { return 0.5 * static_cast<double>(drive_.T_start_scans.size()); }

  const world::FloorPlan& hall_;
  world::RobotParams body_ = create_robot();
  world::NoiseStream wheel_noise_;
  world::NoiseStream laser_noise_;
  WheelErrors errors_;
  Pose2 T_world_robot_ = hall_.T_world_start();
  LaserDrive drive_;
};

}  // namespace

world::FloorPlan laser_hall() {
  const auto hall = bundled_room("hall");
  return hall.starting_at({hall.T_world_start().x_m(), hall.T_world_start().y_m(), 0.0});
}

LaserDrive drive_hall(const world::FloorPlan& hall, std::uint32_t seed) {
  LaserRobot robot(hall, seed);
  for (int round = 0; round < kHallRounds; ++round) {
    for (const Eigen::Vector2d& goal_m : goals_of_round) {
      robot.drive_to(goal_m);
    }
  }
  return robot.drive();
}

}  // namespace echomap::papers
