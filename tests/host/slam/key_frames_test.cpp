// SPDX-License-Identifier: MIT
#include "host/slam/key_frames.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

/// Frames 0 to 9 a metre apart on a line, each with a point a metre ahead.
KeyFrames line() {
  KeyFrames frames;
  for (int i = 0; i < 10; ++i) {
    frames.add({1.0 * i, 0.0, 0.0}, {{{1.0, 0.0}}, {}});
    if (i > 0) {
      const auto number = static_cast<std::size_t>(i);
      frames.join({number - 1, number, {1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity(), false});
    }
  }
  return frames;
}

std::vector<std::size_t> numbers(const std::vector<NearFrame>& near) {
  std::vector<std::size_t> numbers;
  for (const NearFrame& frame : near) {
    numbers.push_back(frame.frame);
  }
  return numbers;
}

TEST(KeyFrames, NearFramesComeInTheOrderOfTheWay) {
  EXPECT_EQ(numbers(line().near(9, 2.5)), (std::vector<std::size_t>{9, 8, 7}));
}

TEST(KeyFrames, AClosedLoopMakesOldFramesNear) {
  KeyFrames frames = line();
  frames.join({1, 9, {0.2, 0.0, 0.0}, Eigen::Matrix3d::Identity(), true});
  const auto near = frames.near(9, 1.3);
  EXPECT_EQ(numbers(near), (std::vector<std::size_t>{9, 1, 8, 0, 2}));
  EXPECT_NEAR(near[3].travelled_m, 1.2, 1e-12);
}

TEST(KeyFrames, PointsMoveWithTheirFrame) {
  KeyFrames frames = line();
  EXPECT_NEAR(frames.map_points_m(4)[0].x(), 5.0, 1e-12);
  const std::vector<PoseEdge> loops{{0, 9, {8.1, 0.0, 0.0}, Eigen::Matrix3d::Identity(), false}};
  ASSERT_TRUE(frames.close_loops(loops));
  EXPECT_LT(frames.map_points_m(9)[0].x(), 9.9);
}

TEST(KeyFrames, ALoopThatCannotBeSolvedForChangesNothing) {
  KeyFrames frames = line();
  const Eigen::Matrix3d unknown =
      Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const std::vector<PoseEdge> loops{{0, 9, {8.1, 0.0, 0.0}, unknown, true}};
  EXPECT_FALSE(frames.close_loops(loops));
  EXPECT_EQ(frames.T_map_frame(9).x_m(), 9.0);
  EXPECT_EQ(frames.graph().edges().size(), 9U);
  EXPECT_EQ(numbers(frames.near(9, 8.5)).back(), 1U) << "no way to the first frame";
}

}  // namespace
}  // namespace echomap::slam
