// SPDX-License-Identifier: MIT
#include "host/slam/kept_way.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

void drive_ahead(EkfSlam& filter, double way_m) {
  filter.move(0, Pose2(way_m, 0.0, 0.0), {.drive_m = way_m}, {.drive_m = 0.01});
}

TEST(KeptWay, KeepsAPoseWhereTheLastIsFar) {
  EkfSlam filter;
  KeptWay way;
  for (int i = 0; i < 10; ++i) {
    way.keep(filter);
    drive_ahead(filter, 0.4);
  }
  EXPECT_EQ(filter.kept_poses(), 4U) << "at 0, 1.2, 2.4 and 3.6 m";
}

TEST(KeptWay, KnowsEachInstantHoweverFewPosesItKeeps) {
  EkfSlam filter;
  KeptWay way({.most_kept = 3});
  for (int i = 0; i < 20; ++i) {
    way.keep(filter);
    way.add({});
    way.add(Pose2(0.5, 0.1, 0.0));
    drive_ahead(filter, 1.0);
  }
  EXPECT_LE(filter.kept_poses(), 3U);
  const auto poses = way.trajectory(filter);
  ASSERT_EQ(poses.size(), 40U);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(poses[2 * i].x_m(), i, 1e-9);
    EXPECT_NEAR(poses[2 * i + 1].x_m(), i + 0.5, 1e-9);
    EXPECT_NEAR(poses[2 * i + 1].y_m(), 0.1, 1e-9);
  }
}

TEST(KeptWay, KeepsTwoPosesAtLeast) {
  EXPECT_THROW(KeptWay({.most_kept = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
