// SPDX-License-Identifier: MIT
#include "host/apps/room_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

using console::ExitCode;
using testing::HasSubstr;

/// A room of 2 x 2 m, the right half of it behind a gap of 0.3 m; the robot starts in the left one.
evaluation::Truth two_halves() {
  constexpr double kCellM = 0.05;
  constexpr int kSide = 40;
  evaluation::Truth truth{{mapping::RasterMap(kSide, kSide, kCellM, {0.0, 0.0}), {}},
                          {{time::RobotTime(), {0.5, 1.0, 0.0}}}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool is_wall = x == kSide / 2 && (y < 17 || y >= 23);
      truth.map.cells.set({x, y},
                          is_wall ? mapping::CellState::kOccupied : mapping::CellState::kFree);
    }
  }
  return truth;
}

session::RobotProfile robot_of_radius(double radius_m) {
  session::RobotProfile profile = session::load_robot_profile("create");
  profile.body_radius_m = radius_m;
  return profile;
}

const RunEnding kComplete{
    "complete", ExitCode::kOk, "it did what it set out to do", "echomap eval"};

TEST(RoomFit, IsTheShareThatTheRobotGetsOver) {
  EXPECT_GT(share_in_reach(two_halves(), 0.1), 0.98);
  EXPECT_NEAR(share_in_reach(two_halves(), 0.2), 0.5, 0.06);
}

TEST(RoomFit, ARobotThatDoesNotFitHasNotFinished) {
  const RunEnding ending =
      with_narrow_room(kComplete, two_halves(), robot_of_radius(0.2), "echomap demo --world hall");
  EXPECT_EQ(ending.code, ExitCode::kUnfinished);
  EXPECT_EQ(ending.outcome, "complete");
  EXPECT_THAT(ending.why, HasSubstr("robot 'create', 40 cm wide, does not fit through the room"));
  EXPECT_EQ(ending.next, "a larger room: echomap demo --world hall");
}

TEST(RoomFit, LeavesOtherEndingsAlone) {
  EXPECT_TRUE(with_narrow_room(kComplete, two_halves(), robot_of_radius(0.1), "").finished());
  const RunEnding lost{"link-lost", ExitCode::kLinkLost, "why", "next"};
  EXPECT_EQ(with_narrow_room(lost, two_halves(), robot_of_radius(0.2), "").why, "why");
}

}  // namespace
}  // namespace echomap::apps
