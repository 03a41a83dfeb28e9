// SPDX-License-Identifier: MIT
#include "host/exploration/hand.hpp"

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

// What a mirrored roll does to a mirrored pose is what the roll does, mirrored.
TEST(Hand, AMirrorTurnsLeftIntoRight) {
  const geometry::Pose2 there = mirrored(geometry::Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(there.x_m(), 1.0);
  EXPECT_EQ(there.y_m(), -2.0);
  EXPECT_EQ(there.heading_rad(), -0.5);
  const Roll roll = mirrored(Roll{0.1, 0.3, 0.07});
  EXPECT_EQ(roll.forward_m_per_s, 0.1);
  EXPECT_EQ(roll.turn_rad_per_s, -0.3);
  EXPECT_EQ(roll.for_s, 0.07);
}

TEST(Hand, TwoMirrorsAreNone) {
  const geometry::Pose2 here(-1.0, 0.4, 2.0);
  EXPECT_EQ(mirrored(mirrored(here)).position_m(), here.position_m());
  EXPECT_EQ(mirrored(mirrored(here)).heading_rad(), here.heading_rad());
}

}  // namespace
}  // namespace echomap::exploration
