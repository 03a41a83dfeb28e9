// SPDX-License-Identifier: MIT
#include "host/mapping/door_evidence.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using Piece = MatchedWall::Piece;

/// A door from 1.4 m to 2.1 m in a wall from 0 to 4 m.
constexpr Piece kDoor{1.4, 2.1};

MatchedWall wall_heard_by(std::vector<FootEcho> echoes) {
  MatchedWall wall{0.0, 2.0, {{0.0, 4.0}}};
  wall.echoes = std::move(echoes);
  return wall;
}

/// What a stop hears there: the nearer side of the door's frame, or wall beside it.
FootEcho echo_of_door(double foot_m, double distance_m) {
  const double inside_m = std::min(foot_m - kDoor.from_m, kDoor.to_m - foot_m);
  return {foot_m,
          distance_m,
          inside_m > 0.0 ? std::hypot(inside_m, distance_m) - distance_m : 0.0,
          0.0,
          0.0};
}

bool is_among(const Piece& door, const std::vector<Piece>& doors) {
  return std::ranges::any_of(
      doors, [&](const Piece& found) { return std::abs(found.from_m - door.from_m) <= 0.2; });
}

TEST(DoorEvidence, AStopRightBeforeAWallTellsItFromADoor) {
  const DoorEvidenceParams params;
  EXPECT_EQ(wall_log_odds(wall_heard_by({}), kDoor, params), 0.0);
  EXPECT_GT(wall_log_odds(wall_heard_by({{1.75, 0.6, 0.0, 0.0, 0.0}}), kDoor, params), 5.0);
  EXPECT_LT(wall_log_odds(wall_heard_by({echo_of_door(1.75, 0.6)}), kDoor, params), -5.0);
  EXPECT_EQ(wall_log_odds(wall_heard_by({{2.4, 0.6, 0.0, 0.0, 0.0}}), kDoor, params), 0.0)
      << "it stood elsewhere";
}

TEST(DoorEvidence, AStopFarOffOrBesideTheFrameTellsLittle) {
  const DoorEvidenceParams params;
  const auto log_odds = [&](double foot_m, double distance_m) {
    return wall_log_odds(wall_heard_by({{foot_m, distance_m, 0.0, 0.0, 0.0}}), kDoor, params);
  };
  EXPECT_LT(log_odds(1.75, 3.0), 0.25 * log_odds(1.75, 0.6));
  EXPECT_LT(log_odds(1.75, 3.0), 2.0);
  EXPECT_LT(log_odds(1.75, 3.0), params.sure_log_odds);
  EXPECT_LT(std::abs(log_odds(1.5, 1.0)), params.sure_log_odds);
}

TEST(DoorEvidence, AnEchoThatNeitherExplainsOutweighsNoneThatSpeaksForADoor) {
  const FootEcho short_echo{1.59, 1.92, -0.024, 0.0, 0.0};
  const auto log_odds = [](std::vector<FootEcho> echoes) {
    return wall_log_odds(wall_heard_by(std::move(echoes)), kDoor, {});
  };
  EXPECT_GT(log_odds({short_echo}), 0.0) << "a door's would be longer yet";
  EXPECT_LT(log_odds({short_echo, echo_of_door(1.91, 1.39)}), DoorEvidenceParams{}.sure_log_odds);
}

TEST(DoorEvidence, SureWallFitsInNoDoor) {
  const DoorEvidenceParams params;
  EXPECT_TRUE(std::isinf(wall_log_odds(wall_heard_by({{1.6, 1.0, 0.0, 0.0, 0.3}}), kDoor, params)));
  EXPECT_FALSE(std::isinf(wall_log_odds(wall_heard_by({{1.6, 1.7, 0.0, 0.0, 0.3}}), kDoor, params)))
      << "from there the other side of the frame sounds alike";
  EXPECT_FALSE(
      std::isinf(wall_log_odds(wall_heard_by({{1.2, 1.0, 0.0, 0.3, 0.25}}), kDoor, params)));
}

TEST(DoorEvidence, EchoesOfBothSidesOfADoorLeaveRoomForIt) {
  const auto doors = doors_left_by_echoes(
      wall_heard_by({echo_of_door(1.42, 1.05), echo_of_door(1.94, 1.56), echo_of_door(2.3, 1.5)}),
      {});
  EXPECT_TRUE(is_among(kDoor, doors));
}

TEST(DoorEvidence, AWallThatWasHeardStepByStepHasNone) {
  std::vector<FootEcho> echoes;
  for (double foot_m = 0.0; foot_m <= 4.0; foot_m += 0.2) {
    echoes.push_back({foot_m, 0.8, 0.0, 0.0, 0.0});
  }
  EXPECT_TRUE(doors_left_by_echoes(wall_heard_by(echoes), {}).empty());
}

TEST(DoorEvidence, WhatNobodyHasHeardIsNotAsked) {
  EXPECT_TRUE(doors_left_by_echoes(wall_heard_by({}), {}).empty());
  EXPECT_TRUE(doors_left_by_echoes(wall_heard_by({{-0.5, 0.4, 0.0, 0.0, 0.0}}), {}).empty());
}

}  // namespace
}  // namespace echomap::mapping
