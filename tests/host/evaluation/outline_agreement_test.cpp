// SPDX-License-Identifier: MIT
#include "host/evaluation/outline_agreement.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Polygon;
using mapping::PolygonMap;

const Polygon square{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}};

TEST(OutlineAgreement, IsFullForTheRoomItself) {
  const auto same = score_outline(PolygonMap(square), {}, square);
  EXPECT_EQ(same.corners, 4U);
  EXPECT_EQ(same.room_corners, 4U);
  EXPECT_EQ(same.corner_rmse_m, 0.0);
  EXPECT_NEAR(*same.outline_rmse_m, 0.0, 1e-12);
}

TEST(OutlineAgreement, CountsACornerTooManyAndAsksForEveryOneOfTheRoom) {
  const Polygon cut{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  const auto agreement = score_outline(PolygonMap(cut), {}, square);
  EXPECT_EQ(agreement.corners, 5U);
  EXPECT_NEAR(*agreement.corner_rmse_m, 0.5, 1e-12);
}

TEST(OutlineAgreement, TakesTheDistanceOfBothOutlinesToEachOther) {
  const Polygon higher{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.1}, {0.0, 2.1}};
  const auto agreement = score_outline(PolygonMap(higher), {}, square);
  // The upper sides are 0.1 m off, but less at both ends of the square's; two sides reach 0.1 m
  // too far.
  const double sum_m3 = 2.0 * 2.0 * 0.01 - 2.0 * 0.002 / 3.0 + 2.0 * 0.001 / 3.0;
  EXPECT_NEAR(*agreement.outline_rmse_m, std::sqrt(sum_m3 / 16.2), 1e-4);
  const Polygon notched{{0.0, 0.0},
                        {2.0, 0.0},
                        {2.0, 2.0},
                        {1.1, 2.0},
                        {1.1, 1.0},
                        {0.9, 1.0},
                        {0.9, 2.0},
                        {0.0, 2.0}};
  EXPECT_NEAR(*score_outline(PolygonMap(notched), {}, square).outline_rmse_m,
              *score_outline(PolygonMap(square), {}, notched).outline_rmse_m,
              1e-9);
}

TEST(OutlineAgreement, PlacesTheOutlineInTheWorld) {
  const geometry::Pose2 T_world_map(2.0, 0.0, geometry::radians(90.0));
  const auto agreement = score_outline(PolygonMap(square), T_world_map, square);
  EXPECT_NEAR(*agreement.corner_rmse_m, 0.0, 1e-12);
}

TEST(OutlineAgreement, HasNoDistanceWithoutAnOutline) {
  const auto none = score_outline(std::nullopt, {}, square);
  EXPECT_EQ(none.corners, 0U);
  EXPECT_FALSE(none.corner_rmse_m);
  EXPECT_FALSE(none.outline_rmse_m);
}

TEST(OutlineAgreement, TakesTheFirstRoundOfWallsForTheRoom) {
  std::vector<geometry::Segment> walls;
  for (std::size_t i = 0; i < square.size(); ++i) {
    walls.push_back(geometry::side(square, i));
  }
  walls.push_back({{0.5, 0.5}, {0.5, 0.7}});
  EXPECT_EQ(first_ring(walls), square);
  walls.erase(walls.begin() + 3);
  EXPECT_TRUE(first_ring(walls).empty());
}

TEST(OutlineAgreement, TakesTheRingsBehindTheFirstForObstacles) {
  const Polygon post{{0.5, 0.5}, {0.5, 0.7}, {0.7, 0.7}};
  std::vector<geometry::Segment> walls{{{5.0, 5.0}, {6.0, 5.0}}};
  for (std::size_t i = 0; i < square.size(); ++i) {
    walls.push_back(geometry::side(square, i));
  }
  EXPECT_TRUE(obstacle_rings(walls).empty());
  walls.push_back({{1.0, 1.0}, {1.5, 1.0}});
  for (std::size_t i = 0; i < post.size(); ++i) {
    walls.push_back(geometry::side(post, i));
  }
  EXPECT_EQ(first_ring(walls), square);
  EXPECT_EQ(obstacle_rings(walls), std::vector<Polygon>{post});
}

}  // namespace
}  // namespace echomap::evaluation
