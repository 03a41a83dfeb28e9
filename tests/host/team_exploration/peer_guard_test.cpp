// SPDX-License-Identifier: MIT
#include "host/team_exploration/peer_guard.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::Drive;
using exploration::Roll;
using geometry::Pose2;
using tests::peer_at;

TEST(PeerGuard, LetsADriveEndWhereHullsKeepTheirMargin) {
  const PeerGuard guard({});
  const std::vector<Peer> peers{peer_at("b", {1.0, 0.0, 0.0})};
  const double free_m = 1.0 - guard.keep_off_m(peers.front()) - PeerGuardParams{}.braking_m;
  EXPECT_EQ(guard.in_the_way(Drive{free_m - 0.01}, {}, peers), nullptr);
  EXPECT_EQ(guard.in_the_way(Drive{free_m + 0.01}, {}, peers), &peers.front());
}

TEST(PeerGuard, NeverHoldsARobotThatLeavesOrTurns) {
  const PeerGuard guard({});
  const std::vector<Peer> peers{peer_at("b", {0.2, 0.0, 0.0})};
  EXPECT_NE(guard.in_the_way(tests::kRollAhead, {}, peers), nullptr);
  EXPECT_EQ(guard.in_the_way(tests::kRollAhead, {0.0, 0.0, std::numbers::pi}, peers), nullptr);
  EXPECT_EQ(guard.in_the_way(Drive{-0.1}, {}, peers), nullptr);
  EXPECT_EQ(guard.in_the_way(exploration::Turn{1.0}, {}, peers), nullptr);
  EXPECT_EQ(guard.in_the_way(exploration::Sweep{}, {}, peers), nullptr);
}

TEST(PeerGuard, ExpectsAPeerThatDrivesFartherOnItsWay) {
  const PeerGuard guard({});
  Peer coming = peer_at("b", {0.6, 0.0, std::numbers::pi});
  EXPECT_EQ(guard.in_the_way(tests::kRollAhead, {}, {coming}), nullptr) << "it stands";
  coming.speed_m_per_s = 0.25;
  coming.age_s = 1.0;
  const std::vector<Peer> peers{coming};
  EXPECT_EQ(guard.in_the_way(tests::kRollAhead, {}, peers), &peers.front());
  Peer leaving = coming;
  leaving.T_map_robot = Pose2(0.6, 0.0, 0.0);
  EXPECT_EQ(guard.in_the_way(tests::kRollAhead, {}, {leaving}), nullptr) << "it can be followed";
}

TEST(PeerGuard, KeepsFartherOffWhereItIsNotSureOfThePeer) {
  const PeerGuard guard({});
  Peer peer = peer_at("b", {});
  const double sure_m = guard.keep_off_m(peer);
  peer.position_stddev_m = 0.1;
  EXPECT_NEAR(guard.keep_off_m(peer), sure_m + 0.1 * PeerGuardParams{}.stddevs, 1e-12);
}

TEST(PeerGuard, NamesTheNearestOfSeveral) {
  const PeerGuard guard({});
  const std::vector<Peer> peers{peer_at("b", {0.26, 0.0, 0.0}), peer_at("c", {0.2, 0.05, 0.0})};
  EXPECT_EQ(guard.in_the_way(tests::kRollAhead, {}, peers), &peers.back());
}

TEST(PeerGuard, RejectsParametersWithoutSense) {
  PeerGuardParams params;
  params.robot_radius_m = 0.0;
  EXPECT_THROW(PeerGuard{params}, std::invalid_argument);
  params = {};
  params.margin_m = -0.1;
  EXPECT_THROW(PeerGuard{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_exploration
