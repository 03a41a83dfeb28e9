// SPDX-License-Identifier: MIT
#include "host/localization/particles.hpp"

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(Particles, HoldAPoseToATenthOfAMillimetreInAHall) {
  Particles particles;
  particles.resize(2);
  particles.set_pose(1, {812.3456, -99.8765, -3.1});
  EXPECT_NEAR(particles.pose(1).x_m(), 812.3456, 1e-4);
  EXPECT_NEAR(particles.pose(1).y_m(), -99.8765, 1e-4);
  EXPECT_NEAR(particles.pose(1).heading_rad(), -3.1, 1e-6);
  EXPECT_EQ(particles.pose(0).x_m(), 0.0);
}

}  // namespace
}  // namespace echomap::localization
