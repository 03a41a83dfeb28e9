// SPDX-License-Identifier: MIT
#include "host/localization/pose_bins.hpp"

#include <algorithm>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(PoseBins, NumberBinsAsTheyCome) {
  PoseBins bins({0.5, 0.2618});
  EXPECT_EQ(bins.insert({3, -4, 5}), 0);
  EXPECT_EQ(bins.insert({3, -4, 6}), 1);
  EXPECT_EQ(bins.insert({3, -4, 5}), 0);
  EXPECT_EQ(bins.find({3, -4, 6}), 1);
  EXPECT_EQ(bins.find({3, -4, 7}), -1);
  EXPECT_EQ(bins.size(), 2U);
}

TEST(PoseBins, HoldEachPoseWithinHalfABinOfItsMiddle) {
  PoseBins bins({0.3, 0.2618});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d pose(
        20.0 * any(random), 20.0 * any(random), std::numbers::pi * (1.0 + any(random)));
    const Eigen::Vector3d off = pose - bins.middle(bins.bin_at(pose.x(), pose.y(), pose.z()));
    ASSERT_LE(std::abs(off.x()), 0.1501);
    ASSERT_LE(std::abs(off.y()), 0.1501);
    ASSERT_LE(std::abs(off.z()), 0.131);
  }
}

TEST(PoseBins, StayApartWhenThereAreMany) {
  PoseBins bins({1.0, 0.2618});
  for (std::int32_t y = -40; y < 40; ++y) {
    for (std::int32_t x = -40; x < 40; ++x) {
      bins.insert({x, y, (x + y + 80) % 24});
    }
  }
  EXPECT_EQ(bins.size(), 6400U);
  EXPECT_EQ(bins.bin(bins.find({7, -9, 6})), (PoseBin{7, -9, 6}));
}

TEST(PoseBins, CloseTheTurn) {
  PoseBins bins({1.0, 0.2618});
  bins.insert({0, 0, 0});
  bins.insert({1, 0, 23});
  bins.insert({0, 0, 2});
  bins.insert({2, 0, 0});
  std::set<std::pair<std::int32_t, std::int32_t>> pairs;
  bins.for_neighbours([&](std::int32_t one, std::int32_t other) {
    pairs.insert({std::min(one, other), std::max(one, other)});
  });
  EXPECT_EQ(pairs, (std::set<std::pair<std::int32_t, std::int32_t>>{{0, 1}, {1, 3}}));
}

TEST(PoseBins, RefuseSizesThatAreNone) {
  EXPECT_THROW(PoseBins({0.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(PoseBins({0.1, 20.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
