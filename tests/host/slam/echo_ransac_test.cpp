// SPDX-License-Identifier: MIT
#include "host/slam/echo_ransac.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/slam/landmark_sighting.hpp"
#include "tests/host/slam/heard_room.hpp"

namespace echomap::slam {
namespace {

using mapping::Echo;
using mapping::EchoFeature;

constexpr int kSeeds = 100;

bool is_found(const EchoFeature& feature, const std::vector<HeardFeature>& found) {
  return std::any_of(found.begin(), found.end(), [&](const HeardFeature& one) {
    const Eigen::Vector2d off = innovation(one.feature.value, feature.value);
    return one.feature.kind == feature.kind &&
           (feature.kind == LandmarkKind::kWall
                ? std::abs(off.x()) < 0.05 && std::abs(off.y()) < 0.2
                : (one.feature.value - feature.value).norm() < 0.1);
  });
}

struct Rate {
  int found = 0;
  int there = 0;
  int strange = 0;  ///< Of nothing that is there.
};

/// Of a kind, over all seeds, from three places near each other.
Rate rate_of(LandmarkKind kind, double outliers) {
  Rate rate;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(seed);
    std::vector<Echo> echoes;
    for (const Eigen::Vector2d& place_m :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.3, -0.1), Eigen::Vector2d(-0.2, 0.3)}) {
      const auto some = sweep(place_m, walls_and_leg(), 0.01, outliers, random);
      echoes.insert(echoes.end(), some.begin(), some.end());
    }
    const auto found = find_features(echoes, {}, random);
    for (const EchoFeature& feature : walls_and_leg()) {
      rate.there += feature.kind == kind ? 1 : 0;
      rate.found += feature.kind == kind && is_found(feature, found) ? 1 : 0;
    }
    for (const HeardFeature& one : found) {
      const bool is_there = std::any_of(
          walls_and_leg().begin(), walls_and_leg().end(), [&](const EchoFeature& feature) {
            return is_found(feature, {one});
          });
      rate.strange += one.feature.kind == kind && !is_there ? 1 : 0;
    }
  }
  return rate;
}

TEST(EchoRansac, FindsTheWallsOfARoomAmongOutliers) {
  for (const double outliers : {0.0, 0.2, 0.4}) {
    const Rate walls = rate_of(LandmarkKind::kWall, outliers);
    EXPECT_GE(walls.found, 0.9 * walls.there) << outliers;
    EXPECT_LE(walls.strange, 0.2 * walls.there) << outliers;
  }
}

TEST(EchoRansac, FindsALegBetweenTheWalls) {
  const Rate legs = rate_of(LandmarkKind::kPoint, 0.1);
  EXPECT_GE(legs.found, 0.8 * legs.there);
}

TEST(EchoRansac, IsAFunctionOfItsSeed) {
  std::mt19937 noise(3);
  const auto echoes = sweep({0.2, 0.1}, walls_and_leg(), 0.02, 0.2, noise);
  std::mt19937 first(7);
  std::mt19937 second(7);
  const auto once = find_features(echoes, {}, first);
  const auto again = find_features(echoes, {}, second);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].feature.value, again[i].feature.value);
    EXPECT_EQ(once[i].echoes, again[i].echoes);
  }
}

TEST(EchoRansac, GivesEachEchoToOneFeature) {
  std::mt19937 random(5);
  const auto echoes = sweep({0.2, 0.1}, walls_and_leg(), 0.02, 0.1, random);
  std::set<std::size_t> given;
  for (const HeardFeature& one : find_features(echoes, {}, random)) {
    for (const std::size_t echo : one.echoes) {
      EXPECT_TRUE(given.insert(echo).second) << echo;
    }
  }
}

TEST(EchoRansac, HearsNothingInTooLittle) {
  std::mt19937 random(1);
  EXPECT_TRUE(find_features({}, {}, random).empty());
  const Echo one{{0.0, 0.0}, 0.0, 1.0, kBeamHalfAngleRad};
  EXPECT_TRUE(find_features({one}, {}, random).empty());
  EXPECT_TRUE(find_features({one, one, one}, {}, random).empty());
}

TEST(EchoRansac, ARobotThatStandsHearsTheSameThingOnce) {
  std::mt19937 random(1);
  const Echo one{{0.0, 0.0}, 0.0, 1.0, kBeamHalfAngleRad};
  const auto found = find_features(std::vector<Echo>(50, one), {}, random);
  EXPECT_LE(found.size(), 1U);
}

TEST(EchoRansac, RefusesParametersWithoutSense) {
  EchoRansacParams params;
  params.range_stddev_m = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.min_point_echoes = 2;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
