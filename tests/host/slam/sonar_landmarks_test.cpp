// SPDX-License-Identifier: MIT
#include "host/slam/sonar_landmarks.hpp"

#include <optional>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/host/slam/heard_room.hpp"

namespace echomap::slam {
namespace {

using mapping::EchoFeature;

/// The sighting of a feature, from the origin; none where nothing is near it.
std::optional<LandmarkSighting> sighting_of(const EchoFeature& feature,
                                            const std::vector<LandmarkSighting>& sightings) {
  for (const LandmarkSighting& sighting : sightings) {
    const Eigen::Vector2d off = innovation(placed_landmark(sighting, {}).landmark, feature.value);
    if (sighting.kind == feature.kind && off.norm() < 0.4) {
      return sighting;
    }
  }
  return std::nullopt;
}

std::vector<LandmarkSighting> seen_from(const Eigen::Vector2d& place_m, std::uint32_t seed) {
  std::mt19937 random(seed);
  return sonar_landmarks(sweep(place_m, walls_and_leg(), 0.03, 0.05, random), {}, random);
}

TEST(SonarLandmarks, SaysHowSureAWallIs) {
  constexpr int kSeeds = 200;
  double nees = 0.0;
  int seen = 0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const auto sightings = seen_from({0.0, 0.0}, seed);
    for (const EchoFeature& feature : walls_and_leg()) {
      if (feature.kind != LandmarkKind::kWall) {
        continue;
      }
      if (const auto sighting = sighting_of(feature, sightings)) {
        const Eigen::Vector2d off = innovation(sighting->value, feature.value);
        nees += off.dot(sighting->noise.inverse() * off);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 0.7 * 4 * kSeeds);
  EXPECT_LT(nees / seen, 3.0) << "2 is right";
  EXPECT_GT(nees / seen, 0.2);
}

TEST(SonarLandmarks, SaysHowSureAPointIs) {
  constexpr int kSeeds = 200;
  double nees = 0.0;
  int seen = 0;
  const EchoFeature& leg = walls_and_leg().back();
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    if (const auto sighting = sighting_of(leg, seen_from({0.0, 0.0}, seed))) {
      const auto expected = expected_sighting(LandmarkKind::kPoint, leg.value, {}, {}).value();
      const Eigen::Vector2d off = innovation(sighting->value, expected.value);
      nees += off.dot(sighting->noise.inverse() * off);
      ++seen;
    }
  }
  EXPECT_GT(seen, kSeeds / 4);
  EXPECT_LT(nees / seen, 3.0) << "2 is right";
  EXPECT_GT(nees / seen, 0.1);
}

TEST(SonarLandmarks, TellsHowLongAWallWasHeard) {
  std::mt19937 random(1);
  const auto echoes = sweep({0.0, 0.0}, walls_and_leg(), 0.01, 0.0, random);
  const auto wall = sighting_of(walls_and_leg()[2], sonar_landmarks(echoes, {}, random));
  ASSERT_TRUE(wall);
  EXPECT_LT(wall->along_from_m, -0.2);
  EXPECT_GT(wall->along_to_m, 0.2);
  EXPECT_LT(wall->along_to_m - wall->along_from_m, 3.0);
}

TEST(SonarLandmarks, KindsCanBeLeftOut) {
  std::mt19937 random(1);
  const auto echoes = sweep({0.0, 0.0}, walls_and_leg(), 0.02, 0.0, random);
  for (const auto& sighting : sonar_landmarks(echoes, {.with_walls = false}, random)) {
    EXPECT_EQ(sighting.kind, LandmarkKind::kPoint);
  }
  for (const auto& sighting : sonar_landmarks(echoes, {.with_points = false}, random)) {
    EXPECT_EQ(sighting.kind, LandmarkKind::kWall);
  }
}

TEST(SonarLandmarks, RefusesDeviationsWithoutSense) {
  EXPECT_THROW(validate(SonarLandmarksParams{.point_stddev_m = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
