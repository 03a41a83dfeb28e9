// SPDX-License-Identifier: MIT
#include "firmware/control/distance_ramp.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::control {
namespace {

std::vector<std::int32_t> steps_of(DistanceRamp& ramp) {
  std::vector<std::int32_t> steps;
  while (!ramp.finished()) {
    steps.push_back(ramp.advance());
  }
  return steps;
}

//  speed 40       ----
//        30      -    -
//        20     -      -
//        10    -        - and what is left over
TEST(DistanceRamp, IsATrapezoid) {
  DistanceRamp ramp;
  ramp.start(245, 40, 10);
  const std::vector<std::int32_t> expected{10, 20, 30, 40, 40, 40, 30, 20, 10, 5};
  EXPECT_EQ(steps_of(ramp), expected);
}

TEST(DistanceRamp, ShortWayIsATriangle) {
  DistanceRamp ramp;
  ramp.start(60, 1000, 10);
  const std::vector<std::int32_t> expected{10, 20, 20, 10};
  EXPECT_EQ(steps_of(ramp), expected);
}

TEST(DistanceRamp, EndsExactlyWithinItsSpeedAndAcceleration) {
  std::mt19937 generator(5);
  for (int i = 0; i < 3000; ++i) {
    const auto distance = static_cast<std::int32_t>(generator() % 3000000);
    const auto change = static_cast<std::int32_t>(1 + generator() % 600);
    const auto cruise = change + static_cast<std::int32_t>(generator() % 40000);
    DistanceRamp ramp;
    ramp.start(distance, cruise, change);
    std::int64_t sum = 0;
    std::int32_t speed = 0;
    while (!ramp.finished()) {
      const std::int32_t step = ramp.advance();
      ASSERT_LE(step, cruise);
      ASSERT_LE(step, speed + change);
      sum += step;
      if (!ramp.finished()) {
        ASSERT_GE(step, speed - change);
        speed = step;
      }
    }
    ASSERT_EQ(sum, distance);
    ASSERT_LE(speed, 2 * change) << "still fast at the end of " << distance;
  }
}

TEST(DistanceRamp, NeverGoesFasterThanItsCruise) {
  DistanceRamp ramp;
  ramp.start(100, 30, 500);
  const std::vector<std::int32_t> expected{30, 30, 30, 10};
  EXPECT_EQ(steps_of(ramp), expected);
}

TEST(DistanceRamp, BrakesToRestAsHardAsTold) {
  DistanceRamp ramp;
  ramp.start(1000000, 1000, 10);
  std::int32_t speed = 0;
  for (int i = 0; i < 60; ++i) {
    speed = ramp.advance();
  }
  ASSERT_EQ(speed, 600);
  ramp.brake(40);
  while (!ramp.finished()) {
    const std::int32_t step = ramp.advance();
    ASSERT_EQ(step, speed - 40);
    speed = step;
  }
  EXPECT_EQ(speed, 40);
}

TEST(DistanceRamp, BrakingNeverGoesPastTheEnd) {
  DistanceRamp ramp;
  ramp.start(60, 1000, 10);
  ramp.advance();
  ramp.advance();
  ramp.brake(1);
  EXPECT_LE(steps_of(ramp).size(), 30U);
  EXPECT_EQ(ramp.advance(), 0);
}

TEST(DistanceRamp, NoWayIsFinishedAtOnce) {
  DistanceRamp ramp;
  ramp.start(0, 100, 10);
  EXPECT_TRUE(ramp.finished());
  EXPECT_EQ(ramp.advance(), 0);
}

}  // namespace
}  // namespace echomap::control
