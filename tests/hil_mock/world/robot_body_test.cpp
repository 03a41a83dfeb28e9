// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_body.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/hil_mock/world/steps.hpp"

namespace echomap::world {
namespace {

DriveParams perfect_drive() {
  DriveParams drive;
  drive.wheel_diameter_stddev = 0.0;
  drive.wheel_mismatch_stddev = 0.0;
  drive.track_stddev = 0.0;
  drive.motor_gain_stddev = 0.0;
  drive.slip_m_per_sqrt_m = 0.0;
  return drive;
}

RobotBody body_in(const FloorPlan& plan, const DriveParams& drive, std::uint32_t seed = 1) {
  return {plan, drive, BodyParams{}, NoiseStream(seed, NoisePurpose::kBody)};
}

void run(RobotBody& body, const WheelDuty& duty, int steps) {
  EncoderChanges changes;
  for (int i = 0; i < steps; ++i) {
    body.step(kStepS, duty, changes);
  }
}

double left_travel_m(const RobotBody& body, const DriveParams& drive) {
  return static_cast<double>(body.left_wheel().counts()) * std::numbers::pi *
         drive.wheel_diameter_m / drive.counts_per_turn;
}

TEST(RobotBody, StraightDriveIsAsLongAsItsCounts) {
  const FloorPlan plan = box_room({}, {0.5, 1.5, 0.0});
  RobotBody body = body_in(plan, perfect_drive());
  run(body, {0.8, 0.8}, 4000);
  EXPECT_NEAR(body.T_world_robot().x_m() - 0.5, left_travel_m(body, perfect_drive()), 2e-4);
  EXPECT_GT(body.T_world_robot().x_m(), 1.5);
  EXPECT_NEAR(body.T_world_robot().y_m(), 1.5, 1e-9);
}

TEST(RobotBody, TurnOnTheSpotIsCountsOverTrack) {
  const FloorPlan plan = box_room();
  RobotBody body = body_in(plan, perfect_drive());
  run(body, {-0.4, 0.4}, 500);
  const double turned_rad = -2.0 * left_travel_m(body, perfect_drive()) / 0.140;
  EXPECT_NEAR(body.T_world_robot().heading_rad(), turned_rad, 4e-3);
  EXPECT_GT(turned_rad, 0.5);
  EXPECT_LT((body.T_world_robot().position_m() - Eigen::Vector2d(2.0, 1.5)).norm(), 1e-9);
}

TEST(RobotBody, ACircleClosesOnItself) {
  const FloorPlan plan = box_room();
  RobotBody body = body_in(plan, perfect_drive());
  run(body, {0.5, 0.8}, 2000);
  const Eigen::Vector2d begin_m = body.T_world_robot().position_m();
  const double heading_rad = body.T_world_robot().heading_rad();
  double turned_rad = 0.0;
  double before_rad = heading_rad;
  while (turned_rad < 2.0 * std::numbers::pi) {
    run(body, {0.5, 0.8}, 1);
    turned_rad += geometry::angle_between(before_rad, body.T_world_robot().heading_rad());
    before_rad = body.T_world_robot().heading_rad();
  }
  EXPECT_LT((body.T_world_robot().position_m() - begin_m).norm(), 1e-3);
}

TEST(RobotBody, AWallStopsItWhileItsWheelsTurn) {
  const FloorPlan plan = box_room({}, {3.5, 1.5, 0.0});
  RobotBody body = body_in(plan, perfect_drive());
  run(body, {0.8, 0.8}, 3000);
  EXPECT_NEAR(body.T_world_robot().x_m(), 4.0 - BodyParams{}.radius_m, 1e-6);
  EXPECT_GT(left_travel_m(body, perfect_drive()), 0.8);
  EXPECT_TRUE(body.contacts().left);
  EXPECT_TRUE(body.contacts().right);
}

TEST(RobotBody, SlidesAlongAWallThatItMeetsAside) {
  const FloorPlan plan = box_room({}, {3.5, 0.5, geometry::radians(60.0)});
  RobotBody body = body_in(plan, perfect_drive());
  run(body, {0.8, 0.8}, 4000);
  EXPECT_NEAR(body.T_world_robot().x_m(), 4.0 - BodyParams{}.radius_m, 1e-6);
  EXPECT_GT(body.T_world_robot().y_m(), 1.3);
  EXPECT_TRUE(body.contacts().right);
  EXPECT_FALSE(body.contacts().left);
}

TEST(RobotBody, NeverEntersAWallWhateverItDoes) {
  const FloorPlan plan = box_room({{rectangle(1.0, 1.0, 1.4, 1.3), {}}});
  RobotBody body = body_in(plan, DriveParams{}, 9);
  NoiseStream noise(4, NoisePurpose::kSonar);
  for (int leg = 0; leg < 200; ++leg) {
    run(body, {noise.uniform() * 2.2 - 0.8, noise.uniform() * 2.2 - 0.8}, 400);
    EXPECT_TRUE(plan.is_free(body.T_world_robot().position_m()));
    EXPECT_GT(plan.clearance_m(body.T_world_robot().position_m()), BodyParams{}.radius_m - 1e-4);
  }
}

TEST(RobotBody, WheelErrorsAndSlipAreThoseOfTheProfile) {
  constexpr int kRuns = 400;
  const FloorPlan plan = box_room({}, {0.5, 1.5, 0.0});
  DriveParams drive = perfect_drive();
  drive.wheel_diameter_stddev = 0.005;
  drive.slip_m_per_sqrt_m = 0.001;
  double scale_squares = 0.0;
  double heading_squares = 0.0;
  double metres = 0.0;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    RobotBody body = body_in(plan, drive, seed);
    EncoderChanges changes;
    for (int i = 0; i < 240; ++i) {
      body.step(0.01, {0.9, 0.9}, changes);
    }
    const double counted_m = left_travel_m(body, drive);
    metres += counted_m / kRuns;
    scale_squares += std::pow((body.T_world_robot().x_m() - 0.5) / counted_m - 1.0, 2) / kRuns;
    heading_squares += std::pow(body.T_world_robot().heading_rad(), 2) / kRuns;
  }
  EXPECT_NEAR(std::sqrt(scale_squares), 0.005, 0.0007);
  EXPECT_NEAR(std::sqrt(heading_squares), 0.001 * std::sqrt(2.0 * metres) / drive.track_m, 0.0015);
}

TEST(RobotBody, RefusesSizesOfZeroAndAStartWithoutRoom) {
  const FloorPlan plan = box_room();
  DriveParams drive;
  drive.track_m = 0.0;
  EXPECT_THROW(body_in(plan, drive), std::invalid_argument);
  const FloorPlan tight = box_room({}, {0.05, 1.5, 0.0});
  EXPECT_THROW(body_in(tight, DriveParams{}), std::invalid_argument);
}

TEST(RobotBody, DoesNotStartOverAHole) {
  const FloorPlan stairs("stairs",
                         {rectangle(0.0, 0.0, 4.0, 3.0), {}},
                         {},
                         {2.95, 1.5, 0.0},
                         {{rectangle(3.0, 0.0, 4.0, 3.0)}, {}});
  EXPECT_THROW(RobotBody(stairs, {}, {}, NoiseStream(1, NoisePurpose::kBody)),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::world
