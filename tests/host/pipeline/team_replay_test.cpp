// SPDX-License-Identifier: MIT
#include "host/pipeline/team_replay.hpp"

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/team_folder.hpp"

namespace echomap::pipeline {
namespace {

using datasets::GivenPose;
using datasets::LandmarkSighting;
using datasets::OdometryStep;

datasets::TeamLog written_team() {
  const tests::ScratchFolder folder;
  tests::write_team_folder(folder.path());
  return datasets::read_mrclam_team(folder.path());
}

TeamReplay played_team(const datasets::TeamLog& team, const TeamReplayParams& params = {}) {
  TeamReplay replay(team.landmarks_m, params);
  for (const auto& record : team.records) {
    replay.play(record);
  }
  return replay;
}

double last_x_m(const TeamReplay& replay, std::int64_t robot) {
  return replay.track(robot).back().belief.T_map_robot.x_m();
}

TEST(TeamReplay, ARobotThatSeesNothingIsCorrectedByTheOneThatSeesIt) {
  const auto team = written_team();
  const TeamReplay joint = played_team(team);
  TeamReplayParams params;
  params.with_peers = false;
  const TeamReplay alone = played_team(team, params);
  EXPECT_NEAR(last_x_m(joint, 1), 6.0, 0.15);
  EXPECT_NEAR(last_x_m(joint, 2), 8.3, 0.15);
  EXPECT_NEAR(last_x_m(alone, 2), 8.0, 0.05);
  EXPECT_GE(joint.track(1).size(), 600U);
  EXPECT_GT(joint.counts(1).landmarks, 590U);
  EXPECT_GT(joint.counts(1).peers, 590U);
  EXPECT_EQ(joint.counts(1).gated, 0U);
  EXPECT_EQ(alone.counts(1).peers, 0U);
  EXPECT_EQ(joint.times_lost(2), 0U);
}

TEST(TeamReplay, ABlindRobotDoesNotUseItsLandmarks) {
  TeamReplayParams params;
  params.blind = {1};
  const TeamReplay replay = played_team(written_team(), params);
  EXPECT_EQ(replay.counts(1).landmarks, 0U);
  EXPECT_GT(replay.counts(1).peers, 590U);
}

TEST(TeamReplay, BeginsWhereAPoseIsGivenShortlyBefore) {
  TeamReplay replay({});
  const datasets::TeamRecord step{2.0, 3, OdometryStep{2.0, {0.1, 0.0, 0.0}}};
  replay.play({1.0, 3, GivenPose{1.0, {5.0, 0.0, 0.0}}});
  replay.play(step);
  EXPECT_TRUE(replay.track(3).empty()) << "a second is too long";
  replay.play({2.1, 3, GivenPose{2.1, {6.0, 0.0, 0.0}}});
  replay.play({2.2, 3, OdometryStep{2.2, {0.1, 0.0, 0.0}}});
  replay.play({2.3, 3, OdometryStep{2.3, {0.1, 0.0, 0.0}}});
  ASSERT_EQ(replay.track(3).size(), 2U);
  EXPECT_EQ(replay.track(3)[0].belief.T_map_robot.x_m(), 6.0);
  EXPECT_NEAR(last_x_m(replay, 3), 6.1, 1e-9);
  EXPECT_TRUE(replay.track(4).empty());
  EXPECT_EQ(replay.times_lost(4), 0U);
}

TEST(TeamReplay, CountsSightingsOfWhatItDoesNotKnow) {
  TeamReplay replay({});
  replay.play({1.0, 1, GivenPose{1.0, {}}});
  replay.play({1.1, 1, OdometryStep{1.1, {}}});
  replay.play({1.2, 1, LandmarkSighting{1.2, 99, 1.0, 0.0}});
  replay.play({1.2, 1, LandmarkSighting{1.2, 2, 1.0, 0.0}});
  replay.play({1.2, 1, LandmarkSighting{1.2, 1, 1.0, 0.0}});
  EXPECT_EQ(replay.counts(1).unknown, 3U);
  EXPECT_EQ(replay.counts(2).unknown, 0U);
}

TEST(TeamReplay, RefusesParametersOutOfRange) {
  TeamReplayParams params;
  params.range_stddev_m = 0.0;
  EXPECT_THROW(TeamReplay({}, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
