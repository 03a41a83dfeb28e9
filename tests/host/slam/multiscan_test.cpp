// SPDX-License-Identifier: MIT
#include "host/slam/multiscan.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

sensors::RangeScan scan_ahead(std::optional<double> range_m) {
  return {{}, {0.1, 0.0, 0.0}, {{0.0, range_m}}, 0.26, 4.0};
}

TEST(MultiscanGathering, BeginsANewOneAfterAMetre) {
  MultiscanGathering gathering({});
  std::optional<OdometryPiece> piece;
  int scans = 0;
  for (double x_m = 0.0; !piece && scans < 100; x_m += 0.125) {
    piece = gathering.add({x_m, 0.0, 0.0}, scan_ahead(2.0));
    ++scans;
  }
  ASSERT_TRUE(piece);
  EXPECT_EQ(scans, 9) << "the ninth lies a metre ahead";
  EXPECT_NEAR(piece->T_before_after.x_m(), 1.0, 1e-9);
  EXPECT_EQ(gathering.finished().echoes.size(), 8U);
  EXPECT_EQ(gathering.open().echoes.size(), 1U);
}

TEST(MultiscanGathering, BeginsANewOneAfterATurn) {
  MultiscanGathering gathering({});
  EXPECT_FALSE(gathering.add({0.0, 0.0, 3.0}, scan_ahead(2.0)));
  const auto piece = gathering.add({0.0, 0.0, 3.0 + 0.6}, scan_ahead(2.0));
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->turn_rad, 0.6, 1e-9);
}

TEST(MultiscanGathering, PlacesEchoesByOdometryFromWhereItBegan) {
  MultiscanGathering gathering({});
  gathering.add({5.0, 5.0, std::numbers::pi / 2}, scan_ahead(2.0));
  gathering.add({5.0, 5.5, std::numbers::pi / 2}, scan_ahead(1.5));
  const auto& echoes = gathering.open().echoes;
  ASSERT_EQ(echoes.size(), 2U);
  EXPECT_LT((echoes[0].middle_m() - Eigen::Vector2d(2.1, 0.0)).norm(), 1e-9);
  EXPECT_LT((echoes[1].middle_m() - Eigen::Vector2d(2.1, 0.0)).norm(), 1e-9);
}

TEST(MultiscanGathering, OfARobotThatStandsKeepsAFewEchoesOfItsWholeStay) {
  MultiscanParams params;
  params.max_echoes = 100;
  MultiscanGathering gathering(params);
  constexpr int kPings = 5000;
  for (int i = 0; i < kPings; ++i) {
    gathering.add({}, scan_ahead(1.0 + 0.001 * i));
  }
  const auto& echoes = gathering.open().echoes;
  EXPECT_GE(echoes.size(), 50U);
  EXPECT_LE(echoes.size(), 100U);
  EXPECT_LT(echoes.front().middle_m().norm(), 1.5);
  EXPECT_GT(echoes.back().middle_m().norm(), 5.5);
}

TEST(MultiscanGathering, LeavesOutSilence) {
  MultiscanGathering gathering({});
  gathering.add({}, scan_ahead(std::nullopt));
  EXPECT_TRUE(gathering.open().echoes.empty());
}

TEST(MultiscanGathering, SaysThatOdometryHasJumped) {
  MultiscanGathering gathering({});
  gathering.add({}, scan_ahead(2.0));
  const auto piece = gathering.add({4.0, 0.0, 0.0}, scan_ahead(2.0));
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->jumped_m, 4.0, 1e-9);
  EXPECT_EQ(piece->path_m, 0.0);
}

TEST(MultiscanGathering, HasNothingToJumpFromBeforeItBegins) {
  MultiscanGathering gathering({});
  gathering.carry({3.0, 0.0, 1.0});
  EXPECT_FALSE(gathering.add({3.0, 0.0, 1.0}, scan_ahead(2.0)));
  EXPECT_EQ(gathering.piece().jumped_rad, 0.0);
  EXPECT_EQ(gathering.open().T_odom_begin.x_m(), 3.0);
}

TEST(MultiscanGathering, TakesAShortStepForAJumpWhereTheRobotWasCarried) {
  MultiscanGathering gathering({});
  gathering.add({}, scan_ahead(2.0));
  gathering.carry({0.3, 0.0, 0.1});
  const auto piece = gathering.add({0.3, 0.0, 0.1}, scan_ahead(2.0));
  ASSERT_TRUE(piece);
  EXPECT_GE(piece->jumped_m, 1.0);
  EXPECT_GE(piece->jumped_rad, 1.0);
  EXPECT_EQ(piece->path_m, 0.0);
  EXPECT_NEAR(piece->T_before_after.x_m(), 0.3, 1e-9);
}

TEST(MultiscanGathering, RefusesParametersWithoutSense) {
  MultiscanParams params;
  params.max_path_m = 0.0;
  EXPECT_THROW(MultiscanGathering{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
