// SPDX-License-Identifier: MIT
#include "host/session/operator_control.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <variant>

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

using exploration::MotionResult;
using std::chrono::milliseconds;

/// A room of 2 m by 2 m around a robot at its origin, all free, with a wall beyond x = 1 m.
pipeline::Snapshot snapshot_of_a_room() {
  pipeline::Snapshot snapshot;
  auto grid = std::make_shared<mapping::OccupancyGrid>();
  for (int y = -20; y < 20; ++y) {
    for (int x = -20; x < 20; ++x) {
      grid->add({x, y}, x == 19 ? 500 : -500);
    }
  }
  snapshot.grid = grid;
  snapshot.trajectory = std::make_shared<const std::vector<pipeline::StampedPose>>();
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>();
  return snapshot;
}

class OperatorControlTest : public testing::Test {
 protected:
  static OperatorParams params() {
    OperatorParams params;
    params.navigator.costs.robot_radius_m = 0.1;
    params.forward_m_per_s = 0.2;
    params.turn_rad_per_s = 2.0;
    return params;
  }
  bool poll_after(milliseconds passed) { return control.poll(now += passed); }
  exploration::Motion next(MotionResult last = MotionResult::kReached) {
    return control.next(snapshot, last);
  }

  OperatorQueue queue;
  int moved = 0;
  OperatorControl control{queue, params(), {.on_moved = [this] { ++moved; }}};
  OperatorControl::WallTime now;
  pipeline::Snapshot snapshot = snapshot_of_a_room();
};

TEST_F(OperatorControlTest, LeavesTheRobotToTheStrategyUntilSomebodyTakesIt) {
  EXPECT_FALSE(poll_after(milliseconds(5)));
  EXPECT_FALSE(control.has_robot());
  queue.push(StopRobot{});
  EXPECT_TRUE(poll_after(milliseconds(5)));
  EXPECT_TRUE(control.has_robot());
  EXPECT_EQ(control.reason(), StandReason::kStopPressed);
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
  queue.push(ResumeStrategy{});
  EXPECT_TRUE(poll_after(milliseconds(5)));
  EXPECT_FALSE(control.has_robot());
}

TEST_F(OperatorControlTest, SteersAsLongAsItIsTold) {
  queue.push(SteerRobot{0.5, -1.0, now});
  EXPECT_TRUE(poll_after(milliseconds(5))) << "the strategy's motion ends";
  const auto motion = next();
  const auto* roll = std::get_if<exploration::Roll>(&motion);
  ASSERT_NE(roll, nullptr);
  EXPECT_DOUBLE_EQ(roll->forward_m_per_s, 0.1);
  EXPECT_DOUBLE_EQ(roll->turn_rad_per_s, -2.0);
  queue.push(SteerRobot{1.0, 0.0, now});
  EXPECT_FALSE(poll_after(milliseconds(100))) << "the wheels roll on";
  EXPECT_FALSE(poll_after(milliseconds(150))) << "0.25 s after it was said";
  EXPECT_TRUE(poll_after(milliseconds(1)));
  EXPECT_EQ(control.reason(), StandReason::kDriverSilent);
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
  queue.push(SteerRobot{1.0, 0.0, now});
  poll_after(milliseconds(5));
  EXPECT_EQ(control.mode(), OperatorMode::kStopped) << "the stick is still held";
}

TEST_F(OperatorControlTest, DoesNotObeyWhatWaitedTooLong) {
  queue.push(SteerRobot{1.0, 0.0, now});
  EXPECT_FALSE(poll_after(milliseconds(3000)));
  EXPECT_FALSE(control.has_robot());
}

TEST_F(OperatorControlTest, CountsHowOftenItTookTheRobotHoweverShort) {
  queue.push(StopRobot{});
  poll_after(milliseconds(5));
  queue.push(ResumeStrategy{});
  poll_after(milliseconds(5));
  EXPECT_EQ(control.times_taken(), 1U);
}

TEST_F(OperatorControlTest, AStickInTheMiddleMayBeSilent) {
  queue.push(SteerRobot{0.0, 0.0, now});
  poll_after(milliseconds(5));
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
  EXPECT_FALSE(poll_after(std::chrono::minutes(1)));
  EXPECT_EQ(control.mode(), OperatorMode::kDriving);
}

TEST_F(OperatorControlTest, GoesOnOnlyAfterTheStickWasLetGoOf) {
  queue.push(SteerRobot{1.0, 0.0, now});
  poll_after(milliseconds(5));
  next();
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next(MotionResult::kBumped)));
  EXPECT_EQ(control.reason(), StandReason::kBumped);
  queue.push(SteerRobot{1.0, 0.0, now});
  poll_after(milliseconds(50));
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
  queue.push(SteerRobot{0.0, 0.0, now});
  poll_after(milliseconds(50));
  queue.push(SteerRobot{-1.0, 0.0, now});
  poll_after(milliseconds(50));
  EXPECT_TRUE(std::holds_alternative<exploration::Roll>(next()));
  EXPECT_EQ(control.reason(), StandReason::kNone);
}

TEST_F(OperatorControlTest, GoesToKnownFloorAndStops) {
  queue.push(GoTo{{0.5, 0.2}});
  EXPECT_TRUE(poll_after(milliseconds(5)));
  EXPECT_FALSE(std::holds_alternative<exploration::Stand>(next(MotionResult::kTakenOver)));
  EXPECT_TRUE(control.goal_m());
  snapshot.latest.T_map_robot = geometry::Pose2(0.5, 0.2, 0.0);
  EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
  EXPECT_EQ(control.reason(), StandReason::kArrived);
  EXPECT_FALSE(control.goal_m());
}

TEST_F(OperatorControlTest, GoesNowhereOffTheFloor) {
  for (const Eigen::Vector2d& at_m : {Eigen::Vector2d(0.97, 0.0), Eigen::Vector2d(5.0, 5.0)}) {
    queue.push(GoTo{at_m});
    poll_after(milliseconds(5));
    EXPECT_TRUE(std::holds_alternative<exploration::Stand>(next()));
    EXPECT_EQ(control.reason(), StandReason::kNoWay);
  }
}

TEST_F(OperatorControlTest, HandsOnWhatIsNoMotion) {
  queue.push(ReportMoved{});
  queue.push(CarryOff{});
  EXPECT_FALSE(poll_after(milliseconds(5)));
  EXPECT_EQ(moved, 1);
}

}  // namespace
}  // namespace echomap::session
