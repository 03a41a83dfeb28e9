// SPDX-License-Identifier: MIT
#include "host/live_page/team_state.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echomap::live_page {
namespace {

using nlohmann::ordered_json;

TEST(TeamState, TellsARobotOnTheMapWithItsTrailAndClaim) {
  TeamRobot robot{"robot0", Presence::kAlive, 0.11, 7, geometry::Pose2(1.0, 2.0, 0.5)};
  robot.trail_m = {{0.0, 0.0}, {0.1, 0.25}};
  robot.claim_m = Eigen::Vector2d(1.5, 2.0);
  EXPECT_EQ(to_json(TeamState{{robot}, std::nullopt}), ordered_json::parse(R"({
    "robots": [{"name": "robot0", "presence": "alive", "radius_m": 0.11, "stops": 7,
                "pose": {"x": 1.0, "y": 2.0, "heading": 0.5},
                "trail": [0.0, 0.0, 0.1, 0.25], "claim": [1.5, 2.0]}],
    "source": null})"));
}

TEST(TeamState, TellsNoPlaceOfARobotThatIsNotJoined) {
  const auto json = to_json(TeamState{{TeamRobot{"robot1", Presence::kGone}}, std::nullopt});
  EXPECT_EQ(json["robots"][0]["presence"], "gone");
  EXPECT_TRUE(json["robots"][0]["pose"].is_null());
  EXPECT_TRUE(json["robots"][0]["claim"].is_null());
}

TEST(TeamState, TellsTheSourceAndItsField) {
  TeamSource source{"searching", Eigen::Vector2d(3.0, 1.0), 0.4, 0.02};
  source.field = TeamField{{0.0, -1.0}, 0.2, 2, {0, 12, 255, 3}};
  EXPECT_EQ(to_json(TeamState{{}, source})["source"], ordered_json::parse(R"({
    "verdict": "searching", "at": [3.0, 1.0], "radius_m": 0.4, "none_probability": 0.02,
    "field": {"origin": [0.0, -1.0], "resolution_m": 0.2, "columns": 2, "cells": [0, 12, 255, 3]}})"));
}

}  // namespace
}  // namespace echomap::live_page
