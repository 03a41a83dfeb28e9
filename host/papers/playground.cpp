// SPDX-License-Identifier: MIT
#include "host/papers/playground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hil_mock/world/contact_physics.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/sonar_physics.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/patch_grid.hpp"
#include "host/models/gaussian_patch.hpp"

namespace echomap::papers {

namespace {

using geometry::Pose2;
using geometry::Segment;

constexpr int kReadings = 72;
/// Between two stops: five moves reach any of the paper's way points (section II.E).
constexpr double kMoveM = 0.42;
constexpr double kStepM = 0.005;

world::Outline box(double left_m, double low_m, double width_m, double depth_m) {
  const double right_m = left_m + width_m;
  const double high_m = low_m + depth_m;
  return {{{left_m, low_m}, {right_m, low_m}, {right_m, high_m}, {left_m, high_m}}, {}};
}

/// The paper's seven phases: through the door, the corners one after the other, and out again; the
/// low block stands on the way along the upper wall and is passed below after the bump.
const std::vector<Eigen::Vector2d> way_points_m = {{1.35, 0.12},
                                                   {1.35, 0.60},
                                                   {2.20, 0.43},
                                                   {2.20, 1.88},
                                                   {1.20, 1.88},
                                                   {1.75, 1.88},
                                                   {1.75, 1.60},
                                                   {1.15, 1.60},
                                                   {0.57, 1.88},
                                                   {0.57, 0.43},
                                                   {1.35, 0.60},
                                                   {1.35, 0.12}};

world::RobotParams ev3() {
  return world::read_robot(
      files::TomlReader::load(files::bundled_file("ev3", "hil_mock/robots", "body")));
}

/// The robot's true pose and its estimate by dead reckoning: wheels that differ from their
/// diameter, slip, and a gyro that counts turns with an error of scale.
class DriftingRobot {
 public:
  DriftingRobot(const world::RobotParams& params, bool with_drift, std::uint32_t seed)
      : params_(params),
        share_(with_drift ? 1.0 : 0.0),
        noise_(seed, world::NoisePurpose::kBody),
        length_scale_(1.0 + share_ * params.drive.wheel_diameter_stddev * noise_.normal()),
        turn_scale_(1.0 + share_ * params.parts.gyro.value().scale_stddev * noise_.normal()),
        T_true_(way_points_m[0].x(), way_points_m[0].y(), 0.5 * std::numbers::pi),
        T_estimate_(T_true_) {}

  const Pose2& T_true() const { return T_true_; }
  const Pose2& T_estimate() const { return T_estimate_; }

  void turn(double angle_rad) {
    T_true_ = T_true_ * Pose2(0.0, 0.0, angle_rad);
    T_estimate_ = T_estimate_ * Pose2(0.0, 0.0, turn_scale_ * angle_rad);
  }
  void drive(double length_m) {
    const double slip_m =
        params_.drive.slip_m_per_sqrt_m * std::sqrt(2.0 * std::abs(length_m)) * noise_.normal();
    T_true_ = T_true_ * Pose2(length_m, 0.0, 0.0);
    T_estimate_ =
        T_estimate_ * Pose2(length_scale_ * length_m, 0.0, share_ * slip_m / params_.drive.track_m);
  }

 private:
  const world::RobotParams& params_;
  double share_;
  world::NoiseStream noise_;
  double length_scale_;
  double turn_scale_;
  Pose2 T_true_;
  Pose2 T_estimate_;
};

/// The drive and what it adds to the grid.
class Mapper {
 public:
  Mapper(const Playground& playground, const PatchDriveParams& params, std::uint32_t seed)
      : playground_(playground),
        params_(params),
        robot_(ev3()),
        sonar_(playground.for_sonar, robot_.sonar),
        noise_(seed, world::NoisePurpose::kSonar),
        body_(robot_, params.with_drift, seed) {
    if (params.with_known_walls) {
      for (const Segment& wall : playground_.known_walls) {
        grid_.mark_wall(wall);
      }
    }
  }

  PatchDrive run() {
    sweep();
    for (std::size_t point = 1; point < way_points_m.size(); ++point) {
      go_to(way_points_m[point]);
    }
    return {grid_.confidence(),
            echoes_m_,
            bumps_,
            (body_.T_estimate().position_m() - body_.T_true().position_m()).norm()};
  }

 private:
  void go_to(const Eigen::Vector2d& goal_m) {
    const Eigen::Vector2d offset_m = goal_m - body_.T_true().position_m();
    body_.turn(geometry::angle_between(body_.T_true().heading_rad(),
                                       std::atan2(offset_m.y(), offset_m.x())));
    const int moves = static_cast<int>(std::ceil(offset_m.norm() / kMoveM));
    for (int i = 0; i < moves; ++i) {
      if (!move(offset_m.norm() / moves)) {
        return;
      }
      sweep();
    }
  }
  /// Whether nothing was in the way.
  bool move(double length_m) {
    for (double done_m = 0.0; done_m < length_m; done_m += kStepM) {
      body_.drive(std::min(kStepM, length_m - done_m));
      const world::Contacts contacts =
          world::contacts_at(playground_.for_bumper, body_.T_true(), robot_.body);
      if (contacts.left || contacts.right) {
        ++bumps_;
        if (params_.with_bumps) {
          add_bump();
        }
        return false;
      }
    }
    return true;
  }
  void sweep() {
    for (int i = 0; i < kReadings; ++i) {
      const Pose2 T_robot_sonar(0.0, 0.0, 2.0 * std::numbers::pi * i / kReadings);
      if (const auto range_m = sonar_.ping_m(body_.T_true() * T_robot_sonar, noise_)) {
        const Pose2 T_grid_sonar = body_.T_estimate() * T_robot_sonar;
        echoes_m_.push_back(T_grid_sonar * Eigen::Vector2d(*range_m, 0.0));
        grid_.add_echo(T_grid_sonar, *range_m);
      }
    }
  }
  void add_bump() {
    const Segment in_robot = models::bumper_line(robot_.body.radius_m, 2.0 * robot_.body.radius_m);
    grid_.add_bump({body_.T_estimate() * in_robot.from_m, body_.T_estimate() * in_robot.to_m});
  }

  const Playground& playground_;
  PatchDriveParams params_;
  world::RobotParams robot_;
  world::SonarPhysics sonar_;
  world::NoiseStream noise_;
  DriftingRobot body_;
  mapping::PatchGrid grid_;
  std::vector<Eigen::Vector2d> echoes_m_;
  int bumps_ = 0;
};

}  // namespace

Playground make_playground() {
  const world::Outline room{{{0.35, 0.25},
                             {1.10, 0.25},
                             {1.10, 0.0},
                             {1.60, 0.0},
                             {1.60, 0.25},
                             {2.42, 0.25},
                             {2.42, 2.00},
                             {0.35, 2.00}},
                            {}};
  const Pose2 T_world_start(1.35, 0.12, 0.5 * std::numbers::pi);
  const std::vector<world::Outline> boxes = {box(0.85, 1.05, 0.25, 0.25),
                                             box(1.70, 0.90, 0.20, 0.30)};
  std::vector<world::Outline> with_block = boxes;
  with_block.push_back(box(1.30, 1.78, 0.20, 0.12));
  return {{"playground", room, boxes, T_world_start},
          {"playground", room, with_block, T_world_start},
          {{{0.35, 0.25}, {1.10, 0.25}},
           {{1.60, 0.25}, {2.42, 0.25}},
           {{2.42, 0.25}, {2.42, 2.00}},
           {{2.42, 2.00}, {0.35, 2.00}},
           {{0.35, 2.00}, {0.35, 0.25}}}};
}

PatchDrive map_playground(const Playground& playground,
                          const PatchDriveParams& params,
                          std::uint32_t seed) {
  return Mapper(playground, params, seed).run();
}

}  // namespace echomap::papers
