// SPDX-License-Identifier: MIT
#include "host/slam/mean_turn.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

TEST(MeanTurn, IsBetweenTwoThatAreAsLikely) {
  const TurnEstimate turn = mean_turn({kNever, kNever, kNever, -7.0, -7.0}, 0.1);
  EXPECT_NEAR(turn.turn_rad, 0.15, 1e-12);
  EXPECT_NEAR(turn.stddev_rad, 0.05, 1e-12);
}

TEST(MeanTurn, IsKnownToHalfAStepAtBest) {
  const TurnEstimate turn = mean_turn({-5000.0, -9000.0, -9000.0}, 0.1);
  EXPECT_NEAR(turn.turn_rad, -0.1, 1e-12);
  EXPECT_EQ(turn.stddev_rad, 0.05);
}

}  // namespace
}  // namespace echomap::slam
