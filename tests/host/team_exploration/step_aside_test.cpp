// SPDX-License-Identifier: MIT
#include "host/team_exploration/step_aside.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/exploration/planning_map.hpp"
#include "host/geometry/segment.hpp"
#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using geometry::Pose2;
using tests::peer_at;

mapping::RasterMap map_of(mapping::OccupancyGrid grid) {
  return exploration::planning_map(tests::snapshot_of(std::move(grid), {}), 0.0, 0.09);
}

TEST(ExpectedWay, LeadsOverTheMapToWhatThePeerClaims) {
  const auto map = map_of(tests::corridor_with_niche());
  const Claim claim{"b", {1.3, 0.6}, 0.1, 2.0, ""};
  const auto path_m = expected_path(map, peer_at("b", {3.5, 0.0, 0.0}), &claim, {});
  ASSERT_GE(path_m.size(), 3U) << "round the corner of the niche";
  EXPECT_LT((path_m.front() - Eigen::Vector2d(3.5, 0.0)).norm(), 0.05);
  EXPECT_LT((path_m.back() - claim.at_m).norm(), 0.05);
}

TEST(ExpectedWay, LeadsStraightAheadWherePeerClaimsNothing) {
  const auto map = map_of(tests::corridor_with_niche());
  const auto path_m = expected_path(map, peer_at("b", {3.5, 0.0, std::numbers::pi}), nullptr, {});
  ASSERT_EQ(path_m.size(), 2U);
  EXPECT_LT((path_m.back() - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-9);
}

TEST(PassingPlace, IsTheNicheOfACorridor) {
  const auto map = map_of(tests::corridor_with_niche());
  const ClearPath path{{{3.5, 0.0}, {-0.9, 0.0}}, 0.3};
  const auto place =
      passing_place(map, {0.5, 0.0}, {peer_at("b", {3.5, 0.0, std::numbers::pi})}, path, {});
  ASSERT_TRUE(place);
  EXPECT_GT(place->at_m.x(), 1.0);
  EXPECT_GE(place->at_m.y(), 0.3);
  EXPECT_NEAR(place->cost_m, 1.5, 1.2);
}

TEST(PassingPlace, IsNotBehindThePeer) {
  const auto map = map_of(tests::corridor_with_niche());
  const ClearPath path{{{0.8, 0.0}, {-0.9, 0.0}}, 0.3};
  EXPECT_FALSE(passing_place(map, {0.2, 0.0}, {peer_at("b", {0.8, 0.0, 0.0})}, path, {}));
}

TEST(PassingPlace, IsHereWhereTheRobotIsNotInTheWay) {
  const auto map = map_of(tests::open_hall());
  const ClearPath path{{{3.0, 0.5}, {-0.5, 0.5}}, 0.3};
  const auto place = passing_place(map, {1.0, -0.3}, {peer_at("b", {3.0, 0.5, 0.0})}, path, {});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->cost_m, 0.0);
}

}  // namespace
}  // namespace echomap::team_exploration
