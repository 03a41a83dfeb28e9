// SPDX-License-Identifier: MIT
#include "host/slam/leave_one_out.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using mapping::LandmarkKind;
using mapping::MatchedSurfaces;

/// A wall of scans 0, 1 and 2, a wall of scans 0 and 1, and a post of scans 1, 2 and 3.
MatchedSurfaces two_walls_and_a_post() {
  MatchedSurfaces matched;
  matched.walls = {{0.0, 1.0, {{-1.0, 1.0}}}, {1.5, 2.0, {{-1.0, 1.0}}}};
  matched.features = {{{LandmarkKind::kWall, {0.0, 1.0}}, {{0, 0}, {1, 0}, {2, 0}}},
                      {{LandmarkKind::kWall, {1.5, 2.0}}, {{0, 1}, {1, 1}}},
                      {{LandmarkKind::kPoint, {0.5, 0.5}}, {{1, 2}, {2, 1}, {3, 0}}}};
  return matched;
}

TEST(LeaveOneOut, KeepsWhatTwoOthersSupport) {
  const MatchedSurfaces others = features_of_others(two_walls_and_a_post(), 0);
  ASSERT_EQ(others.walls.size(), 1U);
  EXPECT_EQ(others.walls[0].offset_m, 1.0);
  ASSERT_EQ(others.features.size(), 2U);
  EXPECT_EQ(others.features[0].feature.kind, LandmarkKind::kWall);
  EXPECT_EQ(others.features[1].feature.kind, LandmarkKind::kPoint);
}

TEST(LeaveOneOut, ASceneThatTheScanHasNoPartInIsWhole) {
  const MatchedSurfaces others = features_of_others(two_walls_and_a_post(), 4);
  EXPECT_EQ(others.walls.size(), 2U);
  EXPECT_EQ(others.features.size(), 3U);
}

}  // namespace
}  // namespace echomap::slam
