// SPDX-License-Identifier: MIT
/// What robots in one room are to each other.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/world/robot_world.hpp"
#include "tests/hil_mock/world/exact_robot.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

constexpr double kHullsM = 2.0 * 0.09;

/// Robots in the box room that step in turn, each told of where the others are.
class PeerRoom {
 public:
  explicit PeerRoom(const std::vector<geometry::Pose2>& starts) {
    for (const geometry::Pose2& start : starts) {
      robots.push_back(std::make_unique<RobotWorld>(
          box_room({}, start), exact_robot(), static_cast<std::uint32_t>(robots.size() + 1)));
    }
    tell_peers(*robots.front());
  }

  void tell_peers(RobotWorld& robot) const {
    std::vector<Disc> peers;
    for (const auto& other : robots) {
      if (const auto hull = other->hull(); hull && other.get() != &robot) {
        peers.push_back(*hull);
      }
    }
    robot.set_peers(peers);
  }

  void drive(double duration_s, const std::vector<WheelDuty>& duties) {
    EncoderChanges changes;
    for (int i = 0; i < std::lround(1000.0 * duration_s); ++i) {
      for (std::size_t k = 0; k < robots.size(); ++k) {
        tell_peers(*robots[k]);
        robots[k]->step(0.001, duties[k], changes);
      }
      nearest_m = std::min(nearest_m, apart_m());
    }
  }

  /// Until the first two touch, and a tenth of a second more: later they slide past each other.
  void drive_until_they_touch(const std::vector<WheelDuty>& duties) {
    for (int i = 0; i < 500 && apart_m() > kHullsM + 1e-6; ++i) {
      drive(0.02, duties);
    }
    drive(0.1, duties);
  }

  double apart_m() const {
    return (robots[0]->T_world_robot().position_m() - robots[1]->T_world_robot().position_m())
        .norm();
  }

  std::vector<std::unique_ptr<RobotWorld>> robots;
  double nearest_m = 1e9;
};

bool presses_both(const RobotWorld& robot) {
  return robot.contacts().left && robot.contacts().right;
}

bool presses_none(const RobotWorld& robot) {
  return !robot.contacts().left && !robot.contacts().right;
}

constexpr WheelDuty kAhead{0.4, 0.4};

TEST(RobotPeers, HearsAPeerAndDoesNotHearOneThatIsHeld) {
  PeerRoom room({{1.0, 1.5, 0.0}, {2.0, 1.5, 0.0}});
  EXPECT_NEAR(room.robots[0]->ping(0.0).value_or(0.0) * 343.2 / 2.0, 0.88, 0.15);
  room.robots[1]->lift();
  room.tell_peers(*room.robots[0]);
  EXPECT_NEAR(room.robots[0]->ping(0.0).value_or(0.0) * 343.2 / 2.0, 2.97, 0.15);
}

TEST(RobotPeers, APeerThatStandsIsNotMovedAndStopsWhoDrivesIntoIt) {
  PeerRoom room({{1.0, 1.5, 0.0}, {1.6, 1.5, 0.5 * std::numbers::pi}});
  room.drive_until_they_touch({kAhead, {}});
  EXPECT_NEAR(room.apart_m(), kHullsM, 1e-9);
  EXPECT_GE(room.nearest_m, kHullsM - 1e-12);
  EXPECT_NEAR(room.robots[1]->T_world_robot().x_m(), 1.6, 1e-9);
  EXPECT_NEAR(room.robots[1]->T_world_robot().y_m(), 1.5, 1e-9);
  EXPECT_TRUE(presses_both(*room.robots[0]));
  EXPECT_TRUE(presses_none(*room.robots[1])) << "it is met at its side";
  EXPECT_EQ(room.robots[0]->body().collisions().bumps, 1);
  EXPECT_EQ(room.robots[1]->body().collisions().bumps, 0);
}

TEST(RobotPeers, TwoThatMeetHeadOnStopAndBothBump) {
  PeerRoom room({{1.0, 1.5, 0.0}, {2.0, 1.5, std::numbers::pi}});
  room.drive_until_they_touch({kAhead, kAhead});
  EXPECT_NEAR(room.apart_m(), kHullsM, 1e-3);
  EXPECT_GE(room.nearest_m, kHullsM - 1e-12);
  for (const auto& robot : room.robots) {
    EXPECT_TRUE(presses_both(*robot));
    EXPECT_EQ(robot->body().collisions().bumps, 1);
    EXPECT_EQ(robot->body().collisions().hard, 0);
  }
  EXPECT_NEAR(room.robots[0]->T_world_robot().x_m(), 1.5 - 0.5 * kHullsM, 0.03)
      << "they have met in the middle";
}

TEST(RobotPeers, WhoCatchesUpFromBehindBumpsAlone) {
  PeerRoom room({{0.5, 1.5, 0.0}, {1.0, 1.5, 0.0}});
  room.drive_until_they_touch({{0.6, 0.6}, {0.3, 0.3}});
  EXPECT_NEAR(room.apart_m(), kHullsM, 1e-3);
  EXPECT_GE(room.nearest_m, kHullsM - 1e-12);
  EXPECT_GT(room.robots[0]->body().collisions().bumps, 0);
  EXPECT_EQ(room.robots[1]->body().collisions().bumps, 0);
  EXPECT_TRUE(presses_none(*room.robots[1]));
}

TEST(RobotPeers, IsNotPutDownOnAPeer) {
  PeerRoom room({{1.0, 1.5, 0.0}, {2.0, 1.5, 0.0}});
  EXPECT_FALSE(room.robots[0]->fits({2.0, 1.5 + kHullsM + 0.04}, 0.05));
  EXPECT_TRUE(room.robots[0]->fits({2.0, 1.5 + kHullsM + 0.06}, 0.05));
}

TEST(RobotPeers, APeerOutOfReachChangesNothing) {
  RobotWorld alone(box_room(), RobotParams{}, 3);
  RobotWorld accompanied(box_room(), RobotParams{}, 3);
  EncoderChanges changes;
  for (int i = 0; i < 2000; ++i) {
    accompanied.set_peers(std::vector<Disc>{{{0.3 + 1e-4 * i, 1.5}, 0.09}});
    alone.step(0.001, {0.5, 0.6}, changes);
    accompanied.step(0.001, {0.5, 0.6}, changes);
    if (i % 100 == 0) {
      EXPECT_EQ(alone.ping(0.0), accompanied.ping(0.0));
    }
  }
  EXPECT_EQ(alone.T_world_robot().position_m(), accompanied.T_world_robot().position_m());
  EXPECT_EQ(alone.T_world_robot().heading_rad(), accompanied.T_world_robot().heading_rad());
}

}  // namespace
}  // namespace echomap::world
