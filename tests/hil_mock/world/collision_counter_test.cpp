// SPDX-License-Identifier: MIT
#include "hil_mock/world/collision_counter.hpp"

#include <gtest/gtest.h>

#include "tests/hil_mock/world/steps.hpp"

namespace echomap::world {
namespace {

class CollisionCounterTest : public testing::Test {
 protected:
  /// A wall that pushes the body with that speed for so many milliseconds, and then lets it go.
  void push(const Eigen::Vector2d& speed_m_per_s, int ms, int free_ms = 1000) {
    for (int i = 0; i < ms; ++i) {
      counter.note(kStepS * speed_m_per_s, kStepS);
    }
    for (int i = 0; i < free_ms; ++i) {
      counter.note(Eigen::Vector2d::Zero(), kStepS);
    }
  }

  CollisionCounter counter{BodyParams{}};
};

TEST_F(CollisionCounterTest, CountsEachBumpOnce) {
  push({-0.2, 0.0}, 100);
  EXPECT_EQ(counter.collisions().bumps, 1);
  push({-0.2, 0.0}, 10, 100);
  push({-0.2, 0.0}, 10);
  EXPECT_EQ(counter.collisions().bumps, 2);
  EXPECT_EQ(counter.collisions().hard, 0);
}

TEST_F(CollisionCounterTest, CallsHardWhatNoBumperFeels) {
  push({0.2, 0.0}, 10);
  EXPECT_EQ(counter.collisions().hard, 1) << "backwards";
  push({0.0, -0.2}, 10);
  EXPECT_EQ(counter.collisions().hard, 2) << "from the left";
  EXPECT_EQ(counter.collisions().bumps, 0);
}

TEST_F(CollisionCounterTest, CallsHardWhatIsTooFast) {
  push({-0.8, 0.0}, 10);
  EXPECT_EQ(counter.collisions().hard, 1);
}

TEST_F(CollisionCounterTest, LetsARobotRubAlongAWall) {
  push({0.0, -0.02}, 1000);
  EXPECT_EQ(counter.collisions().hard, 0);
}

}  // namespace
}  // namespace echomap::world
