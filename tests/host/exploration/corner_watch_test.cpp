// SPDX-License-Identifier: MIT
#include "host/exploration/corner_watch.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::radians;
using mapping::CornerKind;

constexpr WallContact kAlong{false, false, true, 0.08};
constexpr WallContact kLost{};

WallStep step(const WallContact& contact, double travelled_m, double turned_deg) {
  return {{travelled_m, 0.0, 0.0}, contact, travelled_m, radians(turned_deg)};
}

TEST(CornerWatch, NeedsBumpAndVirtualWallTogether) {
  CornerWatch watch;
  watch.add(step({true, false, true, {}}, 1.0, 0.0));
  watch.add(step({false, true, true, {}}, 1.1, 0.0));
  EXPECT_TRUE(watch.marks().empty());
  watch.add(step({true, true, true, {}}, 1.2, 0.0));
  ASSERT_EQ(watch.marks().size(), 1U);
  EXPECT_EQ(watch.marks()[0].kind, CornerKind::kNonReflex);
  EXPECT_EQ(watch.marks()[0].travelled_m, 1.2);
}

TEST(CornerWatch, TakesTheBumpsOfOneCornerTogether) {
  CornerWatch watch;
  for (const double travelled_m : {1.0, 1.0, 1.05, 1.4}) {
    watch.add(step({true, true, true, {}}, travelled_m, 0.0));
  }
  EXPECT_EQ(watch.marks().size(), 2U);
}

TEST(CornerWatch, FindsAReflexCornerInALargeRightTurnOnly) {
  CornerWatch watch;
  watch.add(step(kLost, 0.0, 10.0));
  watch.add(step(kLost, 0.1, -30.0));
  watch.add(step(kAlong, 0.15, -30.0));
  watch.add(step(kLost, 0.2, -30.0));
  watch.add(step(kLost, 0.3, -70.0));
  EXPECT_TRUE(watch.marks().empty());
  watch.add(step(kLost, 0.4, -80.0));
  watch.add(step(kLost, 0.5, -120.0));
  ASSERT_EQ(watch.marks().size(), 1U);
  EXPECT_EQ(watch.marks()[0].kind, CornerKind::kReflex);
  EXPECT_EQ(watch.marks()[0].robot_m.x(), 0.4);
}

// A bump at the edge spins the robot to the left; what counts is the turn since the wall was lost.
TEST(CornerWatch, CountsATurnThatBumpsBreakInto) {
  CornerWatch watch;
  watch.add(step(kLost, 0.0, 0.0));
  watch.add(step({true, false, false, {}}, 0.1, -35.0));
  watch.add(step(kLost, 0.1, -10.0));
  watch.add(step(kLost, 0.2, -50.0));
  EXPECT_EQ(watch.marks().size(), 1U);
}

TEST(CornerWatch, RefusesParametersWithoutSense) {
  EXPECT_THROW(CornerWatch({.reflex_turn_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(CornerWatch({.same_corner_m = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
