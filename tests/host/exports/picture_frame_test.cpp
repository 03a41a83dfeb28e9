// SPDX-License-Identifier: MIT
#include "host/exports/picture_frame.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::exports {
namespace {

TEST(PictureFrame, HoldsTheWholeMapAndThePoints) {
  const auto map = tests::map_from({"..", ".."}, 0.5, {1.0, 2.0});
  const auto frame = frame_of(map, 0.0, {});
  EXPECT_EQ(frame.low_m, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(frame.size_m, Eigen::Vector2d(1.0, 1.0));
  const auto wide = frame_of(map, 0.0, {{-0.1, 2.5}});
  EXPECT_EQ(wide.low_m, Eigen::Vector2d(-0.5, 2.0));
  EXPECT_EQ(wide.size_m, Eigen::Vector2d(2.5, 1.0));
}

TEST(PictureFrame, TurnsPointsAndBack) {
  const auto frame = frame_of(tests::map_from({".."}, 0.5), 0.4, {});
  const Eigen::Vector2d point_m(1.2, -0.7);
  EXPECT_NEAR((frame.in_map_m(frame.in_picture_m(point_m)) - point_m).norm(), 0.0, 1e-12);
  EXPECT_NEAR(frame.in_picture_m({std::cos(0.4), std::sin(0.4)}).y(), 0.0, 1e-12);
}

TEST(PictureFrame, IsNotTurnedByWhatCannotBeSeen) {
  EXPECT_EQ(frame_of(tests::map_from({".."}), 1e-9, {}).turn_rad, 0.0);
}

}  // namespace
}  // namespace echomap::exports
