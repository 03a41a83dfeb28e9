// SPDX-License-Identifier: MIT
#include "hil_mock/world/start_places.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "hil_mock/world/floor_plan_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

/// A wall of 2.6 m across the box room leaves a way round its upper end.
FloorPlan divided_room() {
  return box_room({{rectangle(1.95, 0.0, 2.05, 2.6), {}}}, {1.0, 0.5, 0.0});
}

StartRules rules_for(std::size_t robots, double apart_m) {
  StartRules rules;
  rules.robots = robots;
  rules.apart_m = apart_m;
  return rules;
}

TEST(StartPlaces, TheFirstIsGivenAndTheOthersAreDrawnBySeed) {
  const geometry::Pose2 first(2.0, 1.5, 0.7);
  const auto starts = draw_starts(box_room(), rules_for(3, 1.0), first, 5);
  ASSERT_EQ(starts.size(), 3U);
  EXPECT_EQ(starts[0].position_m(), first.position_m());
  EXPECT_EQ(starts[0].heading_rad(), 0.7);
  const auto again = draw_starts(box_room(), rules_for(3, 1.0), first, 5);
  const auto other = draw_starts(box_room(), rules_for(3, 1.0), first, 6);
  EXPECT_EQ(starts[2].position_m(), again[2].position_m());
  EXPECT_EQ(starts[2].heading_rad(), again[2].heading_rad());
  EXPECT_NE(starts[2].position_m(), other[2].position_m());
}

TEST(StartPlaces, AllAreDrawnWhereNoneIsGiven) {
  const auto starts = draw_starts(box_room(), rules_for(1, 1.0), std::nullopt, 5);
  ASSERT_EQ(starts.size(), 1U);
  EXPECT_NE(starts[0].position_m(), box_room().T_world_start().position_m());
}

TEST(StartPlaces, EachHasRoomAndIsApartFromEachOther) {
  for (std::uint32_t seed = 1; seed < 20; ++seed) {
    const FloorPlan room = box_room({{rectangle(1.0, 1.0, 1.5, 1.5), {}}});
    const auto starts = draw_starts(room, rules_for(4, 1.2), std::nullopt, seed);
    ASSERT_EQ(starts.size(), 4U);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      EXPECT_TRUE(room.is_free(starts[i].position_m()));
      EXPECT_GE(room.clearance_m(starts[i].position_m()), 0.14);
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GE((starts[i].position_m() - starts[k].position_m()).norm(), 1.2 / 1.03);
      }
    }
  }
}

// Across the wall the way is far longer than the line.
TEST(StartPlaces, WaysGoRoundWalls) {
  const geometry::Pose2 first(1.8, 0.3, 0.0);
  bool has_one_behind = false;
  for (std::uint32_t seed = 1; seed < 30; ++seed) {
    const auto starts = draw_starts(divided_room(), rules_for(2, 4.0), first, seed);
    ASSERT_EQ(starts.size(), 2U);
    EXPECT_GT(starts[1].x_m(), 2.0) << "no way before the wall is of 4 m";
    has_one_behind = has_one_behind || (starts[1].position_m() - first.position_m()).norm() < 1.5;
  }
  EXPECT_TRUE(has_one_behind) << "near as the crow flies";
}

TEST(StartPlaces, NoneIsWhereARobotCannotGet) {
  const FloorPlan closed = box_room({{rectangle(1.95, 0.0, 2.05, 3.0), {}}}, {1.0, 0.5, 0.0});
  for (std::uint32_t seed = 1; seed < 10; ++seed) {
    for (const auto& start : draw_starts(closed, rules_for(2, 1.0), std::nullopt, seed)) {
      EXPECT_LT(start.x_m(), 1.95);
    }
  }
}

TEST(StartPlaces, ARoomThatIsTooSmallForThemIsRefused) {
  EXPECT_THROW(draw_starts(box_room(), rules_for(12, 2.0), std::nullopt, 1), std::invalid_argument);
  EXPECT_THROW(draw_starts(box_room(), rules_for(2, 6.0), std::nullopt, 1), std::invalid_argument);
}

class StartsInWorld : public testing::TestWithParam<const char*> {};

// What the experiments with teams ask for.
TEST_P(StartsInWorld, HasPlaceForFourWithTwoMetresBetween) {
  const FloorPlan plan = read_floor_plan(
      files::TomlReader::load(files::bundled_file(GetParam(), "hil_mock/worlds", "world")));
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(draw_starts(plan, rules_for(4, 2.0), std::nullopt, seed).size(), 4U) << seed;
    EXPECT_EQ(draw_starts(plan, rules_for(2, 2.0), plan.T_world_start(), seed).size(), 2U) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, StartsInWorld, testing::Values("office", "corridor_rooms"));

}  // namespace
}  // namespace echomap::world
