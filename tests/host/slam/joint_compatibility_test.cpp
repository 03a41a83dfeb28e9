// SPDX-License-Identifier: MIT
#include "host/slam/joint_compatibility.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

LandmarkSighting point_at(const Eigen::Vector2d& at_m) {
  LandmarkSighting seen;
  seen.value = {at_m.norm(), std::atan2(at_m.y(), at_m.x())};
  seen.noise = Eigen::Vector2d(0.0036, 0.0004).asDiagonal();
  return seen;
}

const std::vector<Eigen::Vector2d> row_of_posts_m{
    {4.0, -3.0}, {4.0, -2.0}, {4.0, -1.0}, {4.0, 0.0}, {4.0, 1.0}, {4.0, 2.5}};

/// A map of a row of posts, by a robot that has then driven aside and lost half a metre.
EkfSlamFilter lost_among_posts() {
  EkfSlamFilter filter;
  for (const Eigen::Vector2d& post_m : row_of_posts_m) {
    filter.add(point_at(post_m));
  }
  filter.move(0, {0.0, 0.0, 0.0}, {}, {0.001, 0.001, 0.001, 0.5});
  return filter;
}

/// What the robot sees that truly stands 0.6 m to its left.
std::vector<LandmarkSighting> seen_aside() {
  std::vector<LandmarkSighting> seen;
  for (const Eigen::Vector2d& post_m : row_of_posts_m) {
    seen.push_back(point_at(post_m - Eigen::Vector2d(0.0, 0.6)));
  }
  return seen;
}

std::size_t right_pairs(const std::vector<Candidate>& pairs) {
  std::size_t right = 0;
  for (const Candidate& pair : pairs) {
    right += pair.sighting == pair.landmark ? 1U : 0U;
  }
  return right;
}

TEST(JointCompatibility, FindsWhatNearestNeighboursMistake) {
  const EkfSlamFilter filter = lost_among_posts();
  const auto candidates = find_candidates(filter, seen_aside(), 9.21, 1.0);

  EXPECT_LT(right_pairs(nearest_neighbours(candidates)), 3U);
  EXPECT_EQ(right_pairs(jointly_compatible(filter, candidates, 20000)), 6U);
}

TEST(JointCompatibility, LeavesOutWhatDoesNotFitTheRest) {
  const EkfSlamFilter filter = lost_among_posts();
  auto seen = seen_aside();
  seen[5] = point_at({4.0, 2.5});
  const auto pairs = jointly_compatible(filter, find_candidates(filter, seen, 9.21, 1.0), 20000);

  EXPECT_EQ(pairs.size(), 5U);
  EXPECT_EQ(right_pairs(pairs), 5U);
}

TEST(JointCompatibility, NeverPairsALandmarkTwice) {
  const EkfSlamFilter filter = lost_among_posts();
  const std::vector<LandmarkSighting> seen{point_at({4.0, 0.0}), point_at({4.01, 0.0})};
  const auto pairs = jointly_compatible(filter, find_candidates(filter, seen, 9.21, 1.0), 20000);

  EXPECT_EQ(pairs.size(), 1U);
}

TEST(JointCompatibility, GivesUpAfterTheStepsItMayTake) {
  const EkfSlamFilter filter = lost_among_posts();
  const auto candidates = find_candidates(filter, seen_aside(), 9.21, 1.0);

  EXPECT_LE(jointly_compatible(filter, candidates, 6).size(), 6U);
  EXPECT_THAT(jointly_compatible(filter, {}, 6), testing::IsEmpty());
}

TEST(ChiSquare, IsThatOfTables) {
  EXPECT_NEAR(chi_square_99(2), 9.210, 0.05);
  EXPECT_NEAR(chi_square_99(4), 13.277, 0.05);
  EXPECT_NEAR(chi_square_99(10), 23.209, 0.05);
  EXPECT_NEAR(chi_square_99(40), 63.691, 0.05);
}

}  // namespace
}  // namespace echomap::slam
