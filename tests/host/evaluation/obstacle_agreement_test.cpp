// SPDX-License-Identifier: MIT
#include "host/evaluation/obstacle_agreement.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/polygon.hpp"
#include "tests/host/evaluation/drawn_truth.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Polygon;
using geometry::Pose2;
using tests::map_from;

const Polygon kRoomM{{0.1, 0.1}, {0.7, 0.1}, {0.7, 0.5}, {0.1, 0.5}};
/// A box of 0.2 m x 0.2 m in its middle, clockwise as the mock writes it.
const Polygon kBoxM{{0.3, 0.2}, {0.3, 0.4}, {0.5, 0.4}, {0.5, 0.2}};

MapTruth drawn_room() {
  MapTruth truth{
      map_from({"########", "#......#", "#......#", "#......#", "#......#", "########"}, kCellM),
      {}};
  add_ring(kRoomM, truth);
  return truth;
}

MapTruth drawn_room_with_box() {
  MapTruth truth{
      map_from({"########", "#......#", "#..  ..#", "#..  ..#", "#......#", "########"}, kCellM),
      {}};
  add_ring(kRoomM, truth);
  add_ring(kBoxM, truth);
  return truth;
}

TEST(ObstacleAgreement, IsFullForTheTruthItself) {
  const auto map =
      map_from({"########", "#......#", "#..##..#", "#..##..#", "#......#", "########"}, kCellM);
  const auto agreement = score_obstacles(map, Pose2(), drawn_room_with_box());
  EXPECT_EQ(agreement.solid_called_free, 0.0);
  EXPECT_EQ(agreement.wall_band_called_free, 0.0);
  EXPECT_EQ(agreement.objects, 1U);
  EXPECT_EQ(agreement.objects_found, 1U);
}

TEST(ObstacleAgreement, CountsTheAreaOfObstaclesThatIsCalledFree) {
  // Of the box's four cells one is free, one occupied and two are unknown.
  const auto map =
      map_from({"########", "#......#", "#...#..#", "#..  ..#", "#......#", "########"}, kCellM);
  EXPECT_NEAR(*score_obstacles(map, Pose2(), drawn_room_with_box()).solid_called_free, 0.25, 1e-9);
}

TEST(ObstacleAgreement, SeesAnErasedObstacle) {
  const auto map =
      map_from({"########", "#......#", "#......#", "#......#", "#......#", "########"}, kCellM);
  const auto agreement = score_obstacles(map, Pose2(), drawn_room_with_box());
  EXPECT_EQ(agreement.solid_called_free, 1.0);
  EXPECT_EQ(agreement.objects_found, 0U);
}

TEST(ObstacleAgreement, ACellInAnObstacleIsNoFind) {
  const auto lone = map_from({"#"}, 0.05, {0.38, 0.28});
  EXPECT_EQ(score_obstacles(lone, Pose2(), drawn_room_with_box()).objects_found, 0U);
  const auto left_side = map_from({"#", "#"}, kCellM, {0.25, 0.2});
  EXPECT_EQ(score_obstacles(left_side, Pose2(), drawn_room_with_box()).objects_found, 0U);
  const auto two_sides = map_from({"##", "# ", "# "}, kCellM, {0.25, 0.15});
  EXPECT_EQ(score_obstacles(two_sides, Pose2(), drawn_room_with_box()).objects_found, 1U);
}

TEST(ObstacleAgreement, AsksOnlyForTheOutlineThatCanBeSeen) {
  // Only to the left of the box is floor, so that its left side is all that is visible.
  MapTruth truth = drawn_room_with_box();
  truth.cells = map_from({"   ", ".. ", ".. ", "   "}, kCellM, {0.1, 0.1});
  const auto left_side = map_from({"#", "#"}, kCellM, {0.25, 0.2});
  EXPECT_EQ(score_obstacles(left_side, Pose2(), truth).objects_found, 1U);
  truth.cells = map_from({" "}, kCellM);
  EXPECT_EQ(score_obstacles(left_side, Pose2(), truth).objects, 0U) << "none is visible";
}

TEST(ObstacleAgreement, AsksForNoObjectBelowTenCentimetres) {
  MapTruth truth = drawn_room();
  add_ring({{0.3, 0.3}, {0.3, 0.36}, {0.36, 0.36}, {0.36, 0.3}}, truth);
  const auto agreement = score_obstacles(truth.cells, Pose2(), truth);
  EXPECT_EQ(agreement.objects, 0U);
  EXPECT_EQ(agreement.solid_called_free, 1.0) << "its area counts";
}

TEST(ObstacleAgreement, CountsTheBandBehindTheWalls) {
  // Floor to 10 cm beyond the right wall, one of the band's four sides (and none of its corners).
  const auto map = map_from({".", ".", ".", "."}, kCellM, {0.7, 0.1});
  const double band_m2 = 2.0 * (0.6 + 0.4) * 0.1 + 0.0314;
  const auto agreement = score_obstacles(map, Pose2(), drawn_room());
  EXPECT_NEAR(*agreement.wall_band_called_free, 0.04 / band_m2, 0.002);
}

TEST(ObstacleAgreement, PlacesTheMapInTheWorld) {
  const auto map = map_from({"..", ".."}, kCellM, {-0.1, -0.1});
  const Pose2 T_world_map(0.4, 0.3, geometry::radians(90.0));
  EXPECT_EQ(score_obstacles(map, T_world_map, drawn_room_with_box()).solid_called_free, 1.0);
  EXPECT_EQ(score_obstacles(map, Pose2(), drawn_room_with_box()).solid_called_free, 0.0);
}

TEST(ObstacleAgreement, HasNothingToSayWithoutARing) {
  MapTruth truth = drawn_room();
  EXPECT_FALSE(score_obstacles(truth.cells, Pose2(), truth).solid_called_free);
  EXPECT_TRUE(score_obstacles(truth.cells, Pose2(), truth).wall_band_called_free);
  truth.walls.pop_back();
  EXPECT_FALSE(score_obstacles(truth.cells, Pose2(), truth).wall_band_called_free);
}

}  // namespace
}  // namespace echomap::evaluation
