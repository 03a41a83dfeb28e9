// SPDX-License-Identifier: MIT
#include "host/papers/nxt_room.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/sonar_physics.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/geometry/angle.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/localization/point_cloud_view.hpp"
#include "host/localization/view_model.hpp"
#include "host/models/gaussian_range.hpp"
#include "host/papers/room_floor.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {

namespace {

using geometry::Pose2;
using localization::RangeReading;

constexpr int kRounds = 10;
constexpr double kTurnRad = geometry::radians(20.0);
constexpr double kForwardM = 0.06;
constexpr double kFirstAngleRad = geometry::radians(30.0);  // pi / 6 of section 4.5.
constexpr double kTurnStddevRad = geometry::radians(0.25);
constexpr double kForwardStddevM = 0.0005;
/// A robot on its arc of ten moves stays free of walls.
constexpr double kClearanceM = 0.15;
/// Particles are scattered over the floor in cells of this size.
constexpr double kFloorCellM = 0.05;

world::SonarParams nxt_sonar() {
  const auto file = files::bundled_file("nxt_tribot", "hil_mock/robots", "body");
  return world::read_robot(files::TomlReader::load(file)).sonar;
}

/// The TriBot that was carried off.
class TriBot {
 public:
  TriBot(const world::FloorPlan& room, std::uint32_t seed)
      : room_(room),
        sonar_(room, nxt_sonar()),
        pings_(seed, world::NoisePurpose::kSonar),
        body_(seed, world::NoisePurpose::kBody) {
    do {
      const Eigen::Vector2d at_m = box_around(room).at(body_.uniform(), body_.uniform());
      T_world_robot_ = {at_m.x(), at_m.y(), (2.0 * body_.uniform() - 1.0) * std::numbers::pi};
    } while (!has_distance_to_go());
  }

  std::vector<RangeReading> look_around() {
    std::vector<RangeReading> readings;
    for (int i = 0; i < 8; ++i) {
      const Pose2 T_robot_sonar(0.0, 0.0, kFirstAngleRad + 0.25 * std::numbers::pi * i);
      readings.push_back({T_robot_sonar, sonar_.ping_m(T_world_robot_ * T_robot_sonar, pings_)});
    }
    return readings;
  }
  void move() {
    const Pose2 turn(0.0, 0.0, kTurnRad);
    T_odom_robot_ = T_odom_robot_ * turn * Pose2(kForwardM, 0.0, 0.0);
    T_world_robot_ = T_world_robot_ * Pose2(0.0, 0.0, kTurnRad + kTurnStddevRad * body_.normal()) *
                     Pose2(kForwardM + kForwardStddevM * body_.normal(), 0.0, 0.0);
  }

  const Pose2& T_odom_robot() const { return T_odom_robot_; }
  const Pose2& T_world_robot() const { return T_world_robot_; }

 private:
  bool has_distance_to_go() const {
    Pose2 T_world_there = T_world_robot_;
    for (int i = 0; i <= kRounds; ++i) {
      const Eigen::Vector2d& there_m = T_world_there.position_m();
      if (!room_.is_free(there_m) || room_.clearance_m(there_m) < kClearanceM) {
        return false;
      }
      T_world_there = T_world_there * Pose2(0.0, 0.0, kTurnRad) * Pose2(kForwardM, 0.0, 0.0);
    }
    return true;
  }

  const world::FloorPlan& room_;
  world::SonarPhysics sonar_;
  world::NoiseStream pings_;
  world::NoiseStream body_;
  Pose2 T_world_robot_;
  Pose2 T_odom_robot_;
};

localization::LocalizerParams nxt_params_of(const NxtTrial& trial) {
  auto params = localization::localizer_params(localization::LocalizerPreset::kNxt, {});
  params.filter.min_particles = trial.particles;
  params.filter.max_particles = trial.particles;
  params.filter.spread_m = trial.spread_m;
  params.filter.spread_rad = trial.spread_rad;
  return params;
}

double heading_off(const Pose2& one, const Pose2& other) {
  return std::abs(geometry::angle_between(one.heading_rad(), other.heading_rad()));
}

NxtOutcome outcome_of(const localization::PoseHypothesis& found,
                      const Pose2& truth,
                      const Eigen::Vector2d& middle_m) {
  const Pose2 T_world_middle(middle_m.x(), middle_m.y(), 0.0);
  const Pose2 twin =
      T_world_middle * Pose2(0.0, 0.0, std::numbers::pi) * T_world_middle.inverse() * truth;
  NxtOutcome outcome;
  outcome.error_m = (found.T_map_robot.position_m() - truth.position_m()).norm();
  outcome.heading_error_rad = heading_off(found.T_map_robot, truth);
  outcome.twin_error_m = (found.T_map_robot.position_m() - twin.position_m()).norm();
  outcome.twin_heading_error_rad = heading_off(found.T_map_robot, twin);
  outcome.stddev_m = std::sqrt(found.covariance.topLeftCorner<2, 2>().trace());
  outcome.T_world_robot = truth;
  return outcome;
}

}  // namespace

std::vector<Eigen::Vector2d> nxt_cloud(const world::FloorPlan& room, std::uint32_t seed) {
  constexpr int kReadings = 120;  // Twice around, in steps of 6 degrees.
  const world::SonarPhysics sonar(room, nxt_sonar());
  world::NoiseStream noise(seed, world::NoisePurpose::kSonar);
  const Box box = box_around(room);
  std::vector<Eigen::Vector2d> cloud_m;
  for (const Eigen::Vector2d& at_m : {box.at(0.25, 0.25),
                                      box.at(0.75, 0.25),
                                      box.at(0.75, 0.75),
                                      box.at(0.25, 0.75),
                                      box.at(0.5, 0.5)}) {
    for (int i = 0; room.is_free(at_m) && i < kReadings; ++i) {
      const Pose2 T_world_sonar(at_m.x(), at_m.y(), geometry::radians(6.0 * i));
      if (const auto range_m = sonar.ping_m(T_world_sonar, noise)) {
        cloud_m.emplace_back(T_world_sonar * Eigen::Vector2d(*range_m, 0.0));
      }
    }
  }
  return cloud_m;
}

NxtOutcome localize_nxt(const world::FloorPlan& room,
                        const std::vector<Eigen::Vector2d>& cloud_m,
                        const NxtTrial& trial,
                        std::uint32_t seed) {
  models::GaussianRangeParams range;
  range.sense_stddev_m = trial.sense_stddev_m;
  localization::ViewModel<localization::PointCloudView, models::GaussianRange> model(
      floor_of(room, kFloorCellM, 0.0),
      localization::PointCloudView(cloud_m),
      models::GaussianRange(range));
  localization::MonteCarloLocalizer localizer(model, nxt_params_of(trial), std::mt19937(seed));
  TriBot robot(room, seed);
  std::vector<Eigen::Vector2d> first_m;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<RangeReading> readings = robot.look_around();
    const std::size_t at_once = trial.resamples_after_each_reading ? 1 : readings.size();
    for (std::size_t i = 0; i < readings.size(); i += at_once) {
      localizer.update(robot.T_odom_robot(), std::span(readings).subspan(i, at_once));
    }
    if (round == 0) {
      first_m = positions_of(localizer.particles());
    }
    robot.move();
    localizer.update(robot.T_odom_robot(), {});
  }
  NxtOutcome outcome = outcome_of(
      localizer.belief().hypotheses.at(0), robot.T_world_robot(), box_around(room).at(0.5, 0.5));
  outcome.first_particles_m = std::move(first_m);
  outcome.last_particles_m = positions_of(localizer.particles());
  return outcome;
}

}  // namespace echomap::papers
