// SPDX-License-Identifier: MIT
#include "host/slam/data_association.hpp"

#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

constexpr double kGate = 9.21;
constexpr double kGapM = 1.0;

LandmarkSighting point(double range_m, double bearing_rad, int label = 0) {
  LandmarkSighting seen;
  seen.value = {range_m, bearing_rad};
  seen.noise = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
  seen.label = label;
  return seen;
}

/// Ahead, from `from_m` to `to_m` along -y.
LandmarkSighting wall(double offset_m, double from_m, double to_m) {
  LandmarkSighting seen = point(offset_m, 0.0);
  seen.kind = LandmarkKind::kWall;
  seen.along_from_m = from_m;
  seen.along_to_m = to_m;
  return seen;
}

std::vector<std::pair<std::size_t, std::size_t>> pairs(const std::vector<Candidate>& candidates) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Candidate& candidate : candidates) {
    pairs.emplace_back(candidate.sighting, candidate.landmark);
  }
  return pairs;
}

TEST(Candidates, AreWithinTheGate) {
  EkfSlamFilter filter;
  filter.add(point(3.0, 0.0));
  filter.add(point(3.3, 0.0));
  filter.add(point(6.0, 0.0));
  const std::vector<LandmarkSighting> seen{point(3.1, 0.0), point(4.5, 0.0)};

  const auto found = find_candidates(filter, seen, kGate, kGapM);

  EXPECT_THAT(pairs(found), testing::ElementsAre(testing::Pair(0, 0), testing::Pair(0, 1)));
  EXPECT_NEAR(found[0].squared_distance, 0.1 * 0.1 / 0.02, 1e-9);
}

TEST(Candidates, AreOfTheSameKindAndLabel) {
  EkfSlamFilter filter;
  filter.add(point(3.0, 0.0, 1));
  filter.add(wall(3.0, -1.0, 1.0));

  EXPECT_THAT(find_candidates(filter, std::vector{point(3.0, 0.0, 2)}, kGate, kGapM),
              testing::IsEmpty());
  EXPECT_THAT(pairs(find_candidates(filter, std::vector{point(3.0, 0.0, 1)}, kGate, kGapM)),
              testing::ElementsAre(testing::Pair(0, 0)));
}

TEST(Candidates, AreFoundHoweverUnsureThePoseIs) {
  const localization::PoseGaussian start{{}, Eigen::Vector3d(4.0, 4.0, 0.25).asDiagonal()};
  EkfSlamFilter filter({&start, 1});
  filter.add(point(5.0, 0.0));
  filter.move(0, {4.0, 0.0, 0.0}, models::odometry_step({}, {4.0, 0.0, 0.0}), {0.1, 1.0, 0.1, 0.1});

  EXPECT_EQ(find_candidates(filter, std::vector{point(3.0, 0.2)}, kGate, kGapM).size(), 1U);
}

TEST(Candidates, OfAWallOverlapWithIt) {
  EkfSlamFilter filter;
  filter.add(wall(3.0, -1.0, 1.0));
  const std::vector<LandmarkSighting> seen{
      wall(3.0, -2.5, -1.5), wall(3.0, 1.5, 4.0), wall(3.0, 2.5, 4.0), wall(3.0, -4.0, -2.5)};

  EXPECT_THAT(pairs(find_candidates(filter, seen, kGate, kGapM)),
              testing::ElementsAre(testing::Pair(0, 0), testing::Pair(1, 0)));
}

TEST(NearestNeighbours, GiveEachLandmarkToItsLikeliestSighting) {
  EkfSlamFilter filter;
  filter.add(point(3.0, 0.0));
  filter.add(point(3.4, 0.0));
  const std::vector<LandmarkSighting> seen{point(3.15, 0.0), point(3.05, 0.0)};

  const auto chosen = nearest_neighbours(find_candidates(filter, seen, kGate, kGapM));

  EXPECT_THAT(pairs(chosen),
              testing::UnorderedElementsAre(testing::Pair(1, 0), testing::Pair(0, 1)));
}

TEST(NearestNeighbours, DoNotPreferALandmarkOfWhichLittleIsKnown) {
  EkfSlamFilter filter;
  LandmarkSighting vague = point(3.6, 0.0);
  vague.noise *= 100.0;
  filter.add(vague);
  filter.add(point(3.0, 0.0));

  const auto chosen =
      nearest_neighbours(find_candidates(filter, std::vector{point(3.15, 0.0)}, kGate, kGapM));

  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(chosen[0].landmark, 1U);
}

TEST(NewSightings, HaveNoCandidate) {
  EkfSlamFilter filter;
  filter.add(point(3.0, 0.0));
  const std::vector<LandmarkSighting> seen{point(9.0, 0.0), point(3.0, 0.0), point(5.0, 1.0)};

  EXPECT_THAT(new_sightings(3, find_candidates(filter, seen, kGate, kGapM)),
              testing::ElementsAre(0, 2));
}

}  // namespace
}  // namespace echomap::slam
