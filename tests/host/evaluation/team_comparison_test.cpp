// SPDX-License-Identifier: MIT
#include "host/evaluation/team_comparison.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/team_folder.hpp"

namespace echomap::evaluation {
namespace {

TeamScore score_of(const datasets::TeamLog& team) {
  TeamComparison comparison(team.landmarks_m);
  for (const auto& record : team.records) {
    comparison.play(record);
  }
  return comparison.score(team.robots);
}

datasets::TeamLog written_team() {
  const tests::ScratchFolder folder;
  tests::write_team_folder(folder.path());
  return datasets::read_mrclam_team(folder.path());
}

TEST(TeamComparison, SaysHowMuchARobotGains) {
  const TeamScore score = score_of(written_team());
  ASSERT_EQ(score.robots.size(), 2U);
  const RobotComparison& second = score.robots[1];
  EXPECT_EQ(second.robot, 2);
  // A twentieth of 6 m at the end, and none at the start.
  EXPECT_NEAR(second.odometry.rmse_m, 0.3 / std::sqrt(3.0), 0.01);
  EXPECT_EQ(second.alone.rmse_m, second.odometry.rmse_m);
  EXPECT_LT(second.joint.rmse_m, 0.1);
  EXPECT_NEAR(
      *second.gain_percent(), 100.0 * (1.0 - second.joint.rmse_m / second.alone.rmse_m), 1e-9);
}

TEST(TeamComparison, PoolsAllRobots) {
  const TeamScore score = score_of(written_team());
  const double first_m = score.robots[0].alone.rmse_m;
  const double second_m = score.robots[1].alone.rmse_m;
  EXPECT_NEAR(
      *score.alone_rmse_m, std::sqrt(0.5 * (first_m * first_m + second_m * second_m)), 1e-12);
  EXPECT_GT(*score.gain_percent, 30.0);
  EXPECT_LE(*score.min_gain_percent, *score.robots[0].gain_percent());
  EXPECT_LE(*score.min_gain_percent, *score.robots[1].gain_percent());
}

TEST(TeamComparison, HasNoFigureWithoutTruth) {
  auto team = written_team();
  // Only where they start is known.
  std::erase_if(team.records, [](const datasets::TeamRecord& record) {
    return record.stamp_s > 1000.05 && std::holds_alternative<datasets::GivenPose>(record.record);
  });
  const TeamScore score = score_of(team);
  ASSERT_EQ(score.robots.size(), 2U);
  EXPECT_FALSE(score.joint_rmse_m);
  EXPECT_FALSE(score.gain_percent);
}

}  // namespace
}  // namespace echomap::evaluation
