// SPDX-License-Identifier: MIT
#include "host/team_map/team_graph.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;

class TeamGraphTest : public ::testing::Test {
 protected:
  TeamGraphTest() {
    first.take(tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.0));
    second.take(tests::ideal_record("b", tests::room_of_posts(), tests::other_round_m(), 1.0));
  }

  std::vector<TeamTrack> begun_at(const Pose2& T_first_second) const {
    std::vector<TeamTrack> tracks{{&first, first.T_map_submaps()}, {&second, {}}};
    for (const Pose2& T_map_submap : second.T_map_submaps()) {
      tracks[1].T_team_submaps.push_back(T_first_second * T_map_submap);
    }
    return tracks;
  }

  double worst_m(const std::vector<TeamTrack>& tracks) const {
    double worst_m = 0.0;
    for (std::size_t i = 0; i < tracks[1].T_team_submaps.size(); ++i) {
      const Eigen::Vector2d true_m = tests::other_round_m()[i] - tests::one_round_m().front();
      worst_m = std::max(worst_m, (tracks[1].T_team_submaps[i].position_m() - true_m).norm());
    }
    return worst_m;
  }

  RobotMap first{mapping::SonarMapperParams{}};
  RobotMap second{mapping::SonarMapperParams{}};
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
};

TEST_F(TeamGraphTest, BringsTheStopsOfTwoRobotsToWhereTheyAgree) {
  auto tracks = begun_at(Pose2(0.04, -0.04, 0.0) * T_true * Pose2(0.0, 0.0, 0.03));
  const double before_m = worst_m(tracks);
  align_team({}, {}, tracks);
  EXPECT_LT(worst_m(tracks), 0.03);
  EXPECT_LT(worst_m(tracks), before_m);
}

TEST_F(TeamGraphTest, LeavesTheFirstSubmapWhereItIs) {
  auto tracks = begun_at(Pose2(0.03, 0.0, 0.0) * T_true);
  align_team({}, {}, tracks);
  EXPECT_NEAR(tracks[0].T_team_submaps[0].x_m(), 0.0, 1e-9);
  EXPECT_NEAR(tracks[0].T_team_submaps[0].heading_rad(), 0.0, 1e-9);
}

/// Nothing but a sighting ties these two, whose rooms have nothing in common.
TEST_F(TeamGraphTest, BringsARobotToWhereItWasSeen) {
  auto tracks = begun_at(Pose2(20.0, 0.0, 0.0));
  align_team({}, {{0, 0, 1, 0, Pose2(20.3, 0.2, 0.0), 0.01, 0.01}}, tracks);
  EXPECT_NEAR(tracks[1].T_team_submaps[0].x_m(), 20.3, 0.03);
  EXPECT_NEAR(tracks[1].T_team_submaps[0].y_m(), 0.2, 0.03);
}

/// Neighbouring readings share errors: as many as there are of them do not make a heading sure.
TEST_F(TeamGraphTest, IsLessSureOfHeadingsTheLessAReadingCounts) {
  const auto heading_stddev_rad = [&](double reading_weight) {
    TeamGraphParams params;
    params.reading_weight = reading_weight;
    auto tracks = begun_at(T_true);
    align_team(params, {}, tracks);
    return tracks[1].heading_stddev_rad;
  };
  EXPECT_GT(heading_stddev_rad(0.1), 1.1 * heading_stddev_rad(1.0));
  EXPECT_LT(heading_stddev_rad(0.1), heading_stddev_rad(1.0) / std::sqrt(0.1));
}

TEST(TeamGraphParams, RefusesInvalidOnes) {
  TeamGraphParams params;
  params.rounds = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.reading_weight = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_map
