// SPDX-License-Identifier: MIT
#include "hil_mock/world/contact_physics.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

using geometry::Pose2;
using geometry::radians;

constexpr double kRadiusM = 0.1;

TEST(ContactPhysics, LeavesABodyInFreeSpaceWhereItIs) {
  const Pose2 T_world_robot = pushed_out(box_room(), {2.0, 1.0, 0.7}, kRadiusM);
  EXPECT_EQ(T_world_robot.position_m(), Eigen::Vector2d(2.0, 1.0));
  EXPECT_EQ(T_world_robot.heading_rad(), 0.7);
}

TEST(ContactPhysics, PushesABodyOutOfAWallAndOutOfANiche) {
  const Pose2 at_wall = pushed_out(box_room(), {3.95, 1.5, 0.0}, kRadiusM);
  EXPECT_NEAR(at_wall.x_m(), 3.9, 1e-9);
  EXPECT_NEAR(at_wall.y_m(), 1.5, 1e-9);
  const Pose2 in_niche = pushed_out(box_room(), {3.97, 2.96, 0.0}, kRadiusM);
  EXPECT_NEAR(in_niche.x_m(), 3.9, 1e-9);
  EXPECT_NEAR(in_niche.y_m(), 2.9, 1e-9);
}

TEST(ContactPhysics, PushesABodyAwayFromAnEdge) {
  const FloorPlan plan = box_room({{rectangle(1.0, 0.5, 1.5, 1.0), {}}});
  const Pose2 T_world_robot = pushed_out(plan, {1.53, 1.04, 0.0}, kRadiusM);
  EXPECT_NEAR((T_world_robot.position_m() - Eigen::Vector2d(1.5, 1.0)).norm(), kRadiusM, 1e-9);
}

struct BumpCase {
  double heading_deg;
  bool left;
  bool right;
};

class Bumpers : public testing::TestWithParam<BumpCase> {};

// The wall x = 4 touches the disc; the heading says where on the robot that is.
TEST_P(Bumpers, AreThoseThatFaceTheWall) {
  const Pose2 T_world_robot(3.9, 1.5, radians(GetParam().heading_deg));
  const Contacts contacts = contacts_at(box_room(), T_world_robot, {.radius_m = kRadiusM});
  EXPECT_EQ(contacts.left, GetParam().left);
  EXPECT_EQ(contacts.right, GetParam().right);
}

INSTANTIATE_TEST_SUITE_P(Headings,
                         Bumpers,
                         testing::Values(BumpCase{0.0, true, true},
                                         BumpCase{-40.0, true, false},
                                         BumpCase{40.0, false, true},
                                         BumpCase{-90.0, false, false},
                                         BumpCase{180.0, false, false}));

TEST(ContactPhysics, PushesABodyOutOfAnotherRobotAlongTheLineOfTheirMiddles) {
  FloorPlan plan = box_room();
  plan.put_robots(std::vector<Disc>{{{2.0, 1.0}, 0.15}});
  for (const double bearing_deg : {0.0, 7.0, 100.0, -163.0}) {
    const Eigen::Vector2d toward = geometry::unit_vector(radians(bearing_deg));
    for (const double apart_m : {0.01, 0.1, 0.24}) {
      const Eigen::Vector2d inside_m = Eigen::Vector2d(2.0, 1.0) + apart_m * toward;
      const Pose2 out = pushed_out(plan, {inside_m.x(), inside_m.y(), 0.0}, kRadiusM);
      EXPECT_NEAR((out.position_m() - Eigen::Vector2d(2.0, 1.0) - 0.25 * toward).norm(), 0.0, 1e-9)
          << bearing_deg << " " << apart_m;
    }
  }
}

TEST(ContactPhysics, AnotherRobotPressesTheBumpersThatFaceIt) {
  FloorPlan plan = box_room();
  plan.put_robots(std::vector<Disc>{{{3.1, 1.5}, 0.2}});
  const BodyParams body{.radius_m = kRadiusM};
  const auto at = [&](double heading_deg) {
    return contacts_at(plan, {2.8, 1.5, radians(heading_deg)}, body);
  };
  EXPECT_TRUE(at(0.0).left && at(0.0).right);
  EXPECT_TRUE(at(-40.0).left && !at(-40.0).right);
  EXPECT_TRUE(!at(40.0).left && at(40.0).right);
  EXPECT_FALSE(at(180.0).left || at(180.0).right);
  EXPECT_FALSE(contacts_at(plan, {2.7975, 1.5, 0.0}, body).left) << "beyond its travel";
}

TEST(ContactPhysics, NoBumperIsPressedBeyondItsTravel) {
  const BodyParams body{.radius_m = kRadiusM};
  EXPECT_TRUE(contacts_at(box_room(), {3.8985, 1.5, 0.0}, body).left);
  EXPECT_FALSE(contacts_at(box_room(), {3.8975, 1.5, 0.0}, body).left);
}

}  // namespace
}  // namespace echomap::world
