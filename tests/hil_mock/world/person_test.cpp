// SPDX-License-Identifier: MIT
#include "hil_mock/world/person.hpp"

#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

constexpr double kPersonStepS = 0.01;
const Disc far_robot{{100.0, 0.0}, 0.1};

PersonParams crossing() { return {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}, 1.0, 0.2, 5.0}; }

/// Walks on until this time.
void walk(Person& person, double& now_s, double until_s, const Disc& robot) {
  while (now_s < until_s - 0.5 * kPersonStepS) {
    now_s += kPersonStepS;
    person.step(kPersonStepS, now_s, std::span(&robot, 1));
  }
}

TEST(Person, ComesWalksItsPathAtItsSpeedAndGoes) {
  Person person(crossing());
  double now_s = 0.0;
  walk(person, now_s, 4.9, far_robot);
  EXPECT_FALSE(person.place());
  walk(person, now_s, 6.0, far_robot);
  ASSERT_TRUE(person.place());
  EXPECT_NEAR(person.place()->middle_m.x(), 1.0, 0.03);
  EXPECT_EQ(person.place()->radius_m, 0.2);
  walk(person, now_s, 7.5, far_robot);
  EXPECT_NEAR(person.place()->middle_m.y(), 0.5, 0.03);
  walk(person, now_s, 8.2, far_robot);
  EXPECT_FALSE(person.place());
}

TEST(Person, WaitsForARobotInItsWayAndGoesOnBehindIt) {
  Person person(crossing());
  double now_s = 0.0;
  const Disc robot{{1.0, 0.0}, 0.1};
  walk(person, now_s, 20.0, robot);
  ASSERT_TRUE(person.place());
  EXPECT_GT((person.place()->middle_m - robot.middle_m).norm(), 0.3);
  EXPECT_LT((person.place()->middle_m - robot.middle_m).norm(), 0.35);
  walk(person, now_s, 21.0, far_robot);
  EXPECT_GT(person.place()->middle_m.x(), 1.5);
}

TEST(Person, DoesNotAppearWhereTheRobotStands) {
  Person person(crossing());
  double now_s = 0.0;
  walk(person, now_s, 6.0, {{0.1, 0.0}, 0.1});
  EXPECT_FALSE(person.place());
}

TEST(Person, StepsAwayFromARobotThatHasDrivenInto) {
  Person person(crossing());
  double now_s = 0.0;
  walk(person, now_s, 6.0, far_robot);
  walk(person, now_s, 7.0, {{0.75, 0.0}, 0.1});
  EXPECT_GT(person.place()->middle_m.x(), 1.9);
}

TEST(Person, WaitsForAnyOfTheRobots) {
  Person person(crossing());
  const std::vector<Disc> robots{far_robot, {{1.0, 0.0}, 0.1}};
  for (double now_s = 0.0; now_s < 20.0; now_s += kPersonStepS) {
    person.step(kPersonStepS, now_s, robots);
  }
  ASSERT_TRUE(person.place());
  EXPECT_LT(person.place()->middle_m.x(), 0.7);
}

TEST(Person, NeedsAPathASpeedAndASize) {
  PersonParams params = crossing();
  params.path_m.resize(1);
  EXPECT_THROW(Person{params}, std::invalid_argument);
  params = crossing();
  params.speed_m_per_s = 0.0;
  EXPECT_THROW(Person{params}, std::invalid_argument);
  params = crossing();
  params.radius_m = -1.0;
  EXPECT_THROW(Person{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::world
