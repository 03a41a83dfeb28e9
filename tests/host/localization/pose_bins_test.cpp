// SPDX-License-Identifier: MIT
#include "host/localization/pose_bins.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

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

TEST(PoseBins, SayWhereInABinEachParticleIs) {
  constexpr std::size_t kCount = BinnedStretch::kMost;
  const PoseBins bins({0.3, 0.2618});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Particles particles;
  particles.resize(kCount + 1);
  for (std::size_t i = 0; i <= kCount; ++i) {
    particles.set_pose(i, {20.0 * any(random), 20.0 * any(random), 3.1415 * any(random)});
  }
  BinnedStretch stretch;
  bins.locate(particles, {1, kCount + 1}, stretch);
  for (std::size_t i = 0; i < kCount; ++i) {
    const Eigen::Vector3d off(stretch.off_x[i], stretch.off_y[i], stretch.off_heading[i]);
    const Eigen::Vector3d pose = bins.middle(stretch.bin(i)) + bins.size_of_bin().cwiseProduct(off);
    ASSERT_LE(off.cwiseAbs().maxCoeff(), 0.5001);
    ASSERT_NEAR(pose.x(), particles.pose(i + 1).x_m(), 1e-5);
    ASSERT_NEAR(pose.y(), particles.pose(i + 1).y_m(), 1e-5);
    const double heading_rad = particles.pose(i + 1).heading_rad();
    ASSERT_NEAR(geometry::angle_between(pose.z(), heading_rad), 0.0, 1e-5);
    ASSERT_GE(stretch.heading[i], 0);
    ASSERT_LT(stretch.heading[i], 24);
  }
}

TEST(PoseBins, BearNumbersThatAreNone) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  Particles particles;
  particles.resize(3);
  particles.x_m = {std::numeric_limits<float>::quiet_NaN(), kInfinite, 1e30F};
  particles.heading_rad = particles.x_m;
  BinnedStretch stretch;
  PoseBins({0.3, 0.2618}).locate(particles, {0, 3}, stretch);
  EXPECT_EQ(stretch.x[0], -16'000'000);
  EXPECT_EQ(stretch.x[1], 16'000'000);
  EXPECT_EQ(stretch.x[2], 16'000'000);
  EXPECT_LT(stretch.heading[2], 24);
}

TEST(PoseBins, MeasureTheShorterWayRound) {
  const PoseBins bins({0.3, 0.2618});
  using Offset = std::array<std::int32_t, 3>;
  EXPECT_EQ(bins.offset({1, 2, 3}, {3, 1, 7}), (Offset{2, -1, 4}));
  EXPECT_EQ(bins.offset({0, 0, 1}, {0, 0, 23}), (Offset{0, 0, -2}));
  EXPECT_EQ(bins.offset({0, 0, 23}, {0, 0, 1}), (Offset{0, 0, 2}));
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
