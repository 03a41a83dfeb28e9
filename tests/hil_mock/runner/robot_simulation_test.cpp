// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_simulation.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::runner {
namespace {

using tests::kMs;

world::RobotParams quiet_robot() {
  world::RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  robot.drive.motor_gain_stddev = 0.0;
  return robot;
}

class RobotSimulationTest : public testing::Test {
 protected:
  FakeBoard board;
  world::RobotWorld robot_world{world::box_room(), quiet_robot(), 1};
  RobotSimulation simulation{board, robot_world};
};

TEST_F(RobotSimulationTest, EveryCountOfAWheelIsOneEdgeInOrderAndInTheFuture) {
  board.duty = {0.6, -0.4};
  simulation.advance_to(1500 * kMs);
  EXPECT_EQ(static_cast<std::int64_t>(board.left_edges.size()),
            robot_world.body().left_wheel().counts());
  EXPECT_EQ(-static_cast<std::int64_t>(board.right_edges.size()),
            robot_world.body().right_wheel().counts());
  EXPECT_GT(board.left_edges.size(), 1000U);
  EXPECT_EQ(board.early_edges, 0);
  for (std::size_t i = 1; i < board.left_edges.size(); ++i) {
    EXPECT_GT(board.left_edges[i].at_ns, board.left_edges[i - 1].at_ns);
  }
}

TEST_F(RobotSimulationTest, KnowsWhenBytesCameAndWhenAMotorWasDriven) {
  EXPECT_EQ(simulation.last_driven_ns(), 0);
  board.duty = {0.0, -0.4};
  board.stop_at_ns = 300 * kMs;
  simulation.advance_to(50 * kMs);
  simulation.receive(std::vector<std::uint8_t>{1, 2});
  simulation.advance_to(1000 * kMs);
  EXPECT_EQ(simulation.last_heard_ns(), 50 * kMs);
  EXPECT_EQ(simulation.last_driven_ns(), 299 * kMs);
}

TEST_F(RobotSimulationTest, APingIsAnsweredAfterTheFlightOfTheSound) {
  board.on_trigger(0);
  ASSERT_EQ(board.echoes.size(), 1U);
  EXPECT_EQ(board.echoes[0].rise_ns, 460'000);
  const double width_s = static_cast<double>(board.echoes[0].fall_ns - 460'000) * 1e-9;
  EXPECT_NEAR(width_s, 2.0 * 1.97 / 343.2, 1e-8);
}

TEST_F(RobotSimulationTest, ATriggerDuringAnEchoIsIgnored) {
  board.on_trigger(0);
  board.on_trigger(board.echoes[0].fall_ns - 1);
  EXPECT_EQ(board.echoes.size(), 1U);
  board.on_trigger(board.echoes[0].fall_ns);
  EXPECT_EQ(board.echoes.size(), 2U);
}

TEST(RobotSimulation, WithoutAnAnswerTheEchoPinStaysHighFor38Milliseconds) {
  FakeBoard board;
  world::RobotParams robot = quiet_robot();
  robot.sonar.max_range_m = 0.5;
  world::RobotWorld world(world::box_room(), robot, 1);
  const RobotSimulation simulation(board, world);
  board.on_trigger(5 * kMs);
  ASSERT_EQ(board.echoes.size(), 1U);
  EXPECT_EQ(board.echoes[0].fall_ns - board.echoes[0].rise_ns, 38 * kMs);
}

TEST_F(RobotSimulationTest, ThePanServoNeedsItsTimeToTurnTheSonar) {
  board.pulse_us = 2400.0;
  simulation.advance_to(100 * kMs);
  board.on_trigger(100 * kMs);
  simulation.advance_to(1000 * kMs);
  board.on_trigger(1000 * kMs);
  const auto range_m = [&](std::size_t i) {
    return static_cast<double>(board.echoes[i].fall_ns - board.echoes[i].rise_ns) * 1e-9 * 343.2 /
           2.0;
  };
  ASSERT_EQ(board.echoes.size(), 2U);
  EXPECT_GT(range_m(0), 1.6) << "not yet at the wall 1.5 m to the left";
  EXPECT_NEAR(range_m(1), 1.5, 1e-3);
}

TEST_F(RobotSimulationTest, BumpersArePressedAtTheWall) {
  board.duty = {1.0, 1.0};
  simulation.advance_to(1000 * kMs);
  EXPECT_FALSE(board.left_bump || board.right_bump);
  simulation.advance_to(8000 * kMs);
  EXPECT_TRUE(board.left_bump && board.right_bump);
}

TEST_F(RobotSimulationTest, RecordsTheTruthFiftyTimesASecond) {
  board.duty = {0.5, 0.5};
  simulation.advance_to(1000 * kMs);
  const auto& trajectory = simulation.trajectory();
  ASSERT_EQ(trajectory.size(), 51U);
  EXPECT_EQ(trajectory.front().at_ns, 0);
  EXPECT_EQ(trajectory.back().at_ns, 1000 * kMs);
  EXPECT_GT(trajectory.back().T_world_robot.x_m(), 2.1);
}

TEST(RobotSimulation, DoesTheSameInManySmallStepsAsInOneLarge) {
  const auto end_pose = [](std::int64_t step_ns) {
    FakeBoard board;
    board.duty = {0.5, 0.6};
    world::RobotWorld world(world::box_room(), quiet_robot(), 7);
    RobotSimulation simulation(board, world);
    for (std::int64_t at_ns = step_ns; at_ns <= 1000 * kMs; at_ns += step_ns) {
      simulation.advance_to(at_ns);
    }
    return world.T_world_robot().position_m();
  };
  EXPECT_EQ(end_pose(1000 * kMs), end_pose(40'000));
}

TEST_F(RobotSimulationTest, DutiesAreToldEveryMillisecondAndWhenTheProgramSetsThem) {
  std::vector<std::int64_t> told_ns;
  simulation.on_duty = [&told_ns](std::int64_t now_ns, const MotorDuty&) {
    told_ns.push_back(now_ns);
  };
  simulation.advance_to(kMs);
  board.time_ns = 1'234'567;
  board.on_duty();
  simulation.advance_to(2 * kMs);
  EXPECT_EQ(told_ns, (std::vector<std::int64_t>{kMs, 1'234'567, 2 * kMs}));
}

TEST_F(RobotSimulationTest, TheDriversInputsAreToldAsOftenAsTheDuties) {
  std::vector<std::int64_t> told_ns;
  world::DriverInputs last_right;
  simulation.on_driver_inputs =
      [&](std::int64_t now_ns, const world::DriverInputs&, const world::DriverInputs& right) {
        told_ns.push_back(now_ns);
        last_right = right;
      };
  board.duty = {0.0, 0.25};
  simulation.advance_to(kMs);
  board.time_ns = 1'234'567;
  board.on_duty();
  EXPECT_EQ(told_ns, (std::vector<std::int64_t>{kMs, 1'234'567}));
  EXPECT_EQ(last_right.pwm, world::pulses(0.25, FakeBoard::kPwmPeriodUs));
}

/// Metres that a robot with this driver rolls after its motors have been switched off.
double stopping_distance_m(world::DriverChip driver) {
  world::RobotParams robot = quiet_robot();
  robot.drive.driver = driver;
  FakeBoard board;
  world::RobotWorld world(world::box_room(), robot, 1);
  RobotSimulation simulation(board, world);
  board.duty = {1.0, 1.0};
  simulation.advance_to(1000 * kMs);
  board.duty = {};
  const Eigen::Vector2d from_m = world.T_world_robot().position_m();
  simulation.advance_to(3000 * kMs);
  return (world.T_world_robot().position_m() - from_m).norm();
}

TEST(RobotSimulation, ARobotRollsOnWhereItsDriverLetsGoOfTheMotors) {
  EXPECT_NEAR(stopping_distance_m(world::DriverChip::kPhaseEnable), 0.45 * 0.08, 0.003);
  EXPECT_NEAR(stopping_distance_m(world::DriverChip::kL298n), 0.056, 0.003);
}

TEST_F(RobotSimulationTest, HandsOnBytesBothWays) {
  const std::vector<std::uint8_t> bytes{1, 0, 255};
  simulation.receive(bytes);
  EXPECT_TRUE(simulation.take_sent().empty());
  simulation.advance_to(kMs);
  EXPECT_EQ(simulation.take_sent(), bytes);
  EXPECT_TRUE(simulation.take_sent().empty());
}

TEST_F(RobotSimulationTest, AKidnapLiftsHoldsAndPlacesTheRobot) {
  simulation.schedule({100 * kMs, 300 * kMs, {1.0, 1.0, 0.5}});
  board.duty = {0.5, 0.5};
  simulation.advance_to(99 * kMs);
  EXPECT_FALSE(robot_world.body().is_lifted());
  simulation.advance_to(101 * kMs);
  EXPECT_TRUE(robot_world.body().is_lifted());
  const double lifted_at_m = robot_world.T_world_robot().x_m();
  simulation.advance_to(299 * kMs);
  EXPECT_EQ(robot_world.T_world_robot().x_m(), lifted_at_m);
  simulation.advance_to(300 * kMs);
  EXPECT_FALSE(robot_world.body().is_lifted());
  EXPECT_NEAR(robot_world.T_world_robot().x_m(), 1.0, 0.002);
  EXPECT_NEAR(robot_world.T_world_robot().heading_rad(), 0.5, 0.01);
  simulation.advance_to(400 * kMs);
  EXPECT_GT(robot_world.T_world_robot().x_m(), 1.01) << "it drives on";
}

/// Where it has place for it.
bool put_box(RobotSimulation& simulation, const Eigen::Vector2d& middle_m, double side_m) {
  const world::Polygon box_m = simulation.box_at(middle_m, side_m);
  const bool has_place = simulation.has_place_for(box_m);
  if (has_place) {
    simulation.put_box(box_m);
  }
  return has_place;
}

TEST(RobotSimulation, ABoxIsPutInTheFrameOfTheStart) {
  FakeBoard board;
  world::RobotWorld world(
      world::box_room({}, {2.0, 1.5, 0.5 * std::numbers::pi}), quiet_robot(), 1);
  RobotSimulation simulation(board, world);
  EXPECT_TRUE(put_box(simulation, {0.5, 1.0}, 0.2));
  ASSERT_EQ(world.plan().boxes_m().size(), 1U);
  EXPECT_TRUE(geometry::contains(world.plan().boxes_m()[0], Eigen::Vector2d(1.0, 2.0)));
  EXPECT_NEAR(world.plan().clearance_m({1.0, 2.0}), 0.1, 1e-12);
}

TEST_F(RobotSimulationTest, NoBoxIsPutWhereTheRobotIsOrWillBePutDown) {
  simulation.schedule({100 * kMs, 300 * kMs, {1.0, 1.0, 0.5}});
  EXPECT_FALSE(put_box(simulation, {0.2, 0.0}, 0.2)) << "at the robot";
  EXPECT_FALSE(put_box(simulation, {-1.0, -0.5}, 0.4)) << "where it will stand";
  EXPECT_FALSE(put_box(simulation, {0.0, 0.0}, 1.0)) << "around the robot";
  EXPECT_FALSE(put_box(simulation, {2.1, 0.0}, 0.4)) << "outside of the room";
  EXPECT_TRUE(robot_world.plan().boxes_m().empty());
  EXPECT_TRUE(put_box(simulation, {0.0, 1.4}, 0.4)) << "half of it in the wall";
  simulation.advance_to(400 * kMs);
  EXPECT_TRUE(put_box(simulation, {0.0, 0.0}, 0.4)) << "where the robot was";
}

TEST(RobotSimulation, AStepperTurnsTheSonarMoreThanOnce) {
  FakeBoard board;
  board.board = "mega";
  world::RobotParams robot = quiet_robot();
  robot.parts.stepper = world::StepperParams{4096.0, 600.0};
  world::PinWires wires;
  for (int i = 0; i < 4; ++i) {
    wires.at(static_cast<std::size_t>(4 + i)) = world::PinWire{
        static_cast<world::PinPart>(static_cast<int>(world::PinPart::kStepperA) + i), false};
  }
  robot.wiring["mega"] = wires;
  world::RobotWorld world(world::box_room(), robot, 1);
  RobotSimulation simulation(board, world);
  constexpr std::array<unsigned, 8> kPatterns = {1, 3, 2, 6, 4, 12, 8, 9};
  constexpr int kTurnAndAQuarter = 5 * 1024;
  for (int i = 1; i <= kTurnAndAQuarter; ++i) {
    for (unsigned coil = 0; coil < 4; ++coil) {
      board.aux_outputs.at(4 + coil) = ((kPatterns.at(i & 7) >> coil) & 1U) != 0;
    }
    simulation.advance_to(2 * kMs * i);
  }
  EXPECT_NEAR(simulation.pan_rad(), 2.5 * std::numbers::pi, 1e-9);
  board.on_trigger(simulation.now_ns());
  ASSERT_EQ(board.echoes.size(), 1U);
  const double width_s =
      static_cast<double>(board.echoes[0].fall_ns - board.echoes[0].rise_ns) * 1e-9;
  EXPECT_NEAR(width_s, 2.0 * 1.5 / 343.2, 1e-8) << "the wall to the left";
}

TEST(RobotSimulation, ARobotWithoutSonarNeverRaisesItsEchoPin) {
  FakeBoard board;
  world::RobotParams robot = quiet_robot();
  robot.has_sonar = false;
  world::RobotWorld world(world::box_room(), robot, 1);
  const RobotSimulation simulation(board, world);
  board.on_trigger(0);
  EXPECT_TRUE(board.echoes.empty());
}

TEST(RobotSimulationWithFaults, ABoardInItsBootLoaderIsResetAndHearsAndSaysNothing) {
  FakeBoard board;
  world::RobotWorld world(
      world::box_room(), quiet_robot(), 1, world::parse_part_faults("board-reset@0.1:0.2"));
  RobotSimulation simulation(board, world);
  simulation.advance_to(100 * kMs);
  EXPECT_LE(board.resets, 1);
  simulation.advance_to(150 * kMs);
  EXPECT_GT(board.resets, 40);
  board.on_sent(7);
  simulation.receive(std::vector<std::uint8_t>{1, 2});
  EXPECT_TRUE(board.received.empty());
  simulation.advance_to(301 * kMs);
  const int resets = board.resets;
  simulation.advance_to(400 * kMs);
  EXPECT_EQ(board.resets, resets);
  EXPECT_TRUE(simulation.take_sent().empty());
  simulation.receive(std::vector<std::uint8_t>{1, 2});
  simulation.advance_to(401 * kMs);
  EXPECT_EQ(simulation.take_sent().size(), 2U);
}

TEST(RobotSimulationWithFaults, ADeadSonarGivesNoPulseAtAll) {
  FakeBoard board;
  world::RobotWorld robot_world(
      world::box_room(), quiet_robot(), 1, world::parse_part_faults("sonar-dead@0.1"));
  RobotSimulation simulation(board, robot_world);
  board.on_trigger(0);
  EXPECT_EQ(board.echoes.size(), 1U);
  simulation.advance_to(200 * kMs);
  board.on_trigger(200 * kMs);
  EXPECT_EQ(board.echoes.size(), 1U);
}

}  // namespace
}  // namespace echomap::runner
