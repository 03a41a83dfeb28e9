// SPDX-License-Identifier: MIT
#include "host/slam/patch_matching.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

PlacedPatches one_patch(double x_m, double y_m, double normal_rad) {
  return {{}, {{{x_m, y_m}, normal_rad, 0.01, 0.05}}, Eigen::Matrix3d::Zero()};
}

TEST(PatchMatching, PairsPatchesOfOneWall) {
  const auto matches = match_patches({one_patch(2.0, 0.0, 0.0), one_patch(2.05, 0.3, 0.1)}, 0, {});
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].later.multiscan, 1U);
  EXPECT_EQ(matches[0].earlier.multiscan, 0U);
  EXPECT_FALSE(matches[0].is_revisit);
}

TEST(PatchMatching, TellsTheTwoSidesOfAWallApart) {
  EXPECT_TRUE(match_patches({one_patch(2.0, 0.0, 0.0), one_patch(2.1, 0.0, 3.1)}, 0, {}).empty());
}

TEST(PatchMatching, LeavesPatchesThatLieFarApart) {
  EXPECT_TRUE(match_patches({one_patch(2.0, 0.0, 0.0), one_patch(2.4, 0.0, 0.0)}, 0, {}).empty());
  EXPECT_TRUE(match_patches({one_patch(2.0, 0.0, 0.0), one_patch(2.0, 0.6, 0.0)}, 0, {}).empty());
}

TEST(PatchMatching, ReachesAcrossAsFarAsTheRobotMayHaveDriftedSinceAnEarlierVisit) {
  const PatchMatchingParams params;
  std::vector<PlacedPatches> multiscans(params.visit_multiscans + 2);
  multiscans.front() = one_patch(2.0, 0.0, 0.0);
  multiscans.back() = one_patch(2.5, 0.0, 0.0);
  EXPECT_TRUE(match_patches(multiscans, 1, params).empty()) << "well known";
  multiscans.back().covariance.diagonal() << 0.04, 0.04, 0.0;
  const auto matches = match_patches(multiscans, 1, params);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_TRUE(matches[0].is_revisit);
  EXPECT_NEAR(matches[0].place_stddev_m, 0.2, 1e-9);
}

TEST(PatchMatching, AsksFewPartnersOfAVisit) {
  const PatchMatchingParams params;
  const std::vector<PlacedPatches> multiscans(8, one_patch(2.0, 0.0, 0.0));
  const auto matches = match_patches(multiscans, 7, params);
  ASSERT_EQ(matches.size(), params.max_partners);
  EXPECT_EQ(matches.back().earlier.multiscan, 6U) << "the latest ones";
}

TEST(PatchMatching, RefusesParametersWithoutSense) {
  PatchMatchingParams params;
  params.max_partners = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
