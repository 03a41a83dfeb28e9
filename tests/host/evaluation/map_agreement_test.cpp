// SPDX-License-Identifier: MIT
#include "host/evaluation/map_agreement.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/evaluation/drawn_truth.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using tests::map_from;

/// A room of 0.4 m x 0.2 m whose walls stand around free cells.
const tests::DrawnMap room{"######", "#....#", "#....#", "######"};

MapTruth truth() {
  const Eigen::Vector2d a(0.1, 0.1);
  const Eigen::Vector2d b(0.5, 0.1);
  const Eigen::Vector2d c(0.5, 0.3);
  const Eigen::Vector2d d(0.1, 0.3);
  return {map_from(room, kCellM), {{a, b}, {b, c}, {c, d}, {d, a}}};
}

TEST(MapAgreement, IsOneForTheTruthItself) {
  const auto agreement = score_map(map_from(room, kCellM), Pose2(), truth());
  EXPECT_EQ(agreement.free_iou, 1.0);
  EXPECT_EQ(agreement.wall_recall, 1.0);
  // Walls run along the cells' edges, half a cell from the nearer centres.
  EXPECT_GE(agreement.wall_rmse_m.value(), 0.05);
  EXPECT_LT(agreement.wall_rmse_m.value(), 0.06);
}

TEST(MapAgreement, CountsIntersectionOverUnion) {
  // Of the eight free cells seven are found, and one wall is taken for floor.
  const auto agreement =
      score_map(map_from({"######", "#...  ", ".....#", "######"}, kCellM), Pose2(), truth());
  EXPECT_NEAR(agreement.free_iou, 7.0 / 9.0, 1e-12);
}

TEST(MapAgreement, MissesFloorOutsideOfTheMapsPicture) {
  const auto map = map_from({"..", ".."}, kCellM, {0.1, 0.1});
  EXPECT_NEAR(score_map(map, Pose2(), truth()).free_iou, 4.0 / 8.0, 1e-12);
}

TEST(MapAgreement, PlacesTheMapByTheStartPoseAlone) {
  // The same room drawn in the frame of a robot that started at (0.3, 0.2) looking along +y.
  const Pose2 T_world_map(0.3, 0.2, std::numbers::pi / 2.0);
  const auto turned =
      map_from({"####", "#..#", "#..#", "#..#", "#..#", "####"}, kCellM, {-0.2, -0.3});
  const auto agreement = score_map(turned, T_world_map, truth());
  EXPECT_EQ(agreement.free_iou, 1.0);
  EXPECT_EQ(agreement.wall_recall, 1.0);
  EXPECT_LT(score_map(turned, Pose2(), truth()).free_iou, 0.5);
}

TEST(MapAgreement, MeasuresHowFarWallsAreOff) {
  // One occupied cell, its centre 0.25 m to the right of the right wall.
  const auto map = map_from({"       #"}, kCellM, {0.0, 0.15});
  EXPECT_NEAR(score_map(map, Pose2(), truth()).wall_rmse_m.value(), 0.25, 1e-9);
}

TEST(MapAgreement, HasNoWallErrorWithoutAWall) {
  const auto agreement = score_map(map_from({"...."}, kCellM), Pose2(), truth());
  EXPECT_FALSE(agreement.wall_rmse_m.has_value());
  EXPECT_EQ(agreement.wall_recall, 0.0);
}

TEST(MapAgreement, CountsOnlyWallsThatBorderOnFloor) {
  MapTruth with_hidden_wall = truth();
  with_hidden_wall.walls.push_back({{2.0, 2.0}, {9.0, 2.0}});
  EXPECT_EQ(score_map(map_from(room, kCellM), Pose2(), with_hidden_wall).wall_recall, 1.0);
}

TEST(MapAgreement, RecallsTheShareOfWallThatIsDrawn) {
  // Only the lower wall, 0.4 m of 1.2 m, and what of the side walls lies within a cell of it.
  const auto map = map_from({"######"}, kCellM);
  const double recall = score_map(map, Pose2(), truth()).wall_recall;
  EXPECT_GT(recall, 0.39);
  EXPECT_LT(recall, 0.43);
}

TEST(MapAgreement, RefusesAMapThatLiesSomewhereElse) {
  const auto map = map_from({"...."}, kCellM, {1e12, 0.0});
  EXPECT_THROW(score_map(map, Pose2(), truth()), std::invalid_argument);
}

TEST(MapAgreement, OfAnUnknownMapIsNothing) {
  const auto agreement = score_map(map_from({" "}, kCellM), Pose2(), truth());
  EXPECT_EQ(agreement.free_iou, 0.0);
}

}  // namespace
}  // namespace echomap::evaluation
