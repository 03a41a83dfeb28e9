// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

const Outline pillar{rectangle(1.0, 1.0, 1.5, 1.5), {}};

TEST(FloorPlan, FreeSpaceIsToTheLeftOfEveryWallWhateverTheSense) {
  Polygon clockwise = rectangle(0.0, 0.0, 4.0, 3.0);
  std::reverse(clockwise.begin(), clockwise.end());
  const FloorPlan plan("room", {clockwise, {}}, {pillar}, {2.0, 2.0, 0.0});
  ASSERT_EQ(plan.walls().size(), 8U);
  for (const Wall& wall : plan.walls()) {
    const Eigen::Vector2d middle = 0.5 * (wall.segment.from_m + wall.segment.to_m);
    EXPECT_TRUE(plan.is_free(middle + 0.1 * left_normal(wall.segment))) << middle.transpose();
    EXPECT_FALSE(plan.is_free(middle - 0.1 * left_normal(wall.segment))) << middle.transpose();
  }
}

TEST(FloorPlan, EveryWallKeepsItsMaterialWhenTheSenseIsTurned) {
  Polygon clockwise = rectangle(0.0, 0.0, 4.0, 3.0);
  std::reverse(clockwise.begin(), clockwise.end());
  // The second side runs from (4, 3) down to (4, 0).
  const FloorPlan plan(
      "room", {clockwise, {{Material::kSmooth}, {Material::kRough}}}, {}, {2.0, 2.0, 0.0});
  for (const Wall& wall : plan.walls()) {
    const bool right = wall.segment.from_m.x() == 4.0 && wall.segment.to_m.x() == 4.0;
    EXPECT_EQ(wall.surface.material == Material::kRough, right) << wall.segment.from_m.transpose();
  }
}

TEST(FloorPlan, TellsNichesFromEdges) {
  const FloorPlan plan = box_room({pillar});
  int niches = 0;
  for (const Corner& corner : plan.corners()) {
    EXPECT_NEAR(std::abs(corner.turn_rad), 0.5 * std::numbers::pi, 1e-12);
    niches += corner.turn_rad > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(niches, 4);
  EXPECT_EQ(plan.corners().size(), 8U);
}

TEST(FloorPlan, MeasuresClearance) {
  EXPECT_DOUBLE_EQ(box_room({pillar}).clearance_m({2.0, 1.25}), 0.5);
  EXPECT_DOUBLE_EQ(box_room({pillar}).clearance_m({3.9, 2.0}), 4.0 - 3.9);
}

TEST(FloorPlan, RefusesWhatIsNoRoom) {
  const Outline outside{rectangle(3.5, 1.0, 4.5, 1.5), {}};
  EXPECT_THROW(box_room({outside}), std::invalid_argument);
  EXPECT_THROW(box_room({pillar}, {1.2, 1.2, 0.0}), std::invalid_argument);
  EXPECT_THROW(box_room({}, {5.0, 1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(FloorPlan("line", {{{0.0, 0.0}, {1.0, 0.0}}, {}}, {}, {}), std::invalid_argument);
}

TEST(FloorPlan, TakesAnotherStart) {
  const FloorPlan moved = box_room({pillar}).starting_at({3.0, 2.0, 1.0});
  EXPECT_EQ(moved.T_world_start().position_m(), Eigen::Vector2d(3.0, 2.0));
  EXPECT_EQ(moved.walls().size(), 8U);
  EXPECT_THROW(moved.starting_at({1.2, 1.2, 0.0}), std::invalid_argument);
}

TEST(FloorPlan, AHoleIsNotFreeAndNoWall) {
  const FloorPlan plan("room",
                       {rectangle(0.0, 0.0, 4.0, 3.0), {}},
                       {},
                       {2.0, 1.5, 0.0},
                       {{rectangle(3.0, 0.0, 4.0, 3.0)}, {}});
  EXPECT_TRUE(plan.is_hole({3.5, 1.0}));
  EXPECT_FALSE(plan.is_free({3.5, 1.0}));
  EXPECT_FALSE(plan.is_hole({2.9, 1.0}));
  EXPECT_EQ(plan.walls().size(), 4U);
  EXPECT_THROW(plan.starting_at({3.5, 1.0, 0.0}), std::invalid_argument);
}

TEST(FloorPlan, RefusesAHoleBeyondTheRoomOrOfNoArea) {
  const auto with_hole = [](Polygon hole_m) {
    return FloorPlan("room",
                     {rectangle(0.0, 0.0, 4.0, 3.0), {}},
                     {},
                     {2.0, 1.5, 0.0},
                     {{std::move(hole_m)}, {}});
  };
  EXPECT_THROW(with_hole(rectangle(3.0, 0.0, 5.0, 3.0)), std::invalid_argument);
  EXPECT_THROW(with_hole({{1.0, 1.0}, {1.5, 1.5}}), std::invalid_argument);
}

TEST(FloorPlan, PeopleStandInTheRoomAndNotInItsTruth) {
  FloorPlan plan = box_room();
  const std::vector<Disc> people{{{2.0, 1.5}, 0.2}};
  plan.put_people(people);
  EXPECT_GT(plan.walls().size(), 4U);
  EXPECT_EQ(plan.still_walls().size(), 4U);
  for (std::size_t i = 4; i < plan.walls().size(); ++i) {
    const Eigen::Vector2d corner_m = plan.walls()[i].segment.from_m;
    EXPECT_NEAR((corner_m - people[0].middle_m).norm(), 0.2, 1e-9);
    EXPECT_EQ(plan.walls()[i].surface.material, Material::kRough);
  }
  EXPECT_EQ(plan.clearance_m({2.0, 1.5}), 1.5);
  EXPECT_TRUE(plan.is_free({2.0, 1.5}));
  plan.put_people({});
  EXPECT_EQ(plan.walls().size(), 4U);
}

TEST(FloorPlan, RobotsStandBehindPeopleAndMoveAlone) {
  FloorPlan plan = box_room();
  const std::vector<Disc> people{{{3.0, 1.0}, 0.2}};
  const std::vector<Disc> robots{{{1.0, 1.0}, 0.1}, {{1.0, 2.0}, 0.1}};
  plan.put_robots(robots);
  plan.put_people(people);
  ASSERT_EQ(plan.walls().size(), 4U + 12U + 24U);
  EXPECT_EQ(plan.walls_besides_robots().size(), 16U);
  EXPECT_NEAR((plan.walls()[4].segment.from_m - people[0].middle_m).norm(), 0.2, 1e-9);
  EXPECT_NEAR((plan.walls()[16].segment.from_m - robots[0].middle_m).norm(), 0.1, 1e-9);
  EXPECT_EQ(plan.walls()[16].surface.material, Material::kRough);
  EXPECT_EQ(plan.clearance_m({1.0, 1.5}), 1.0);
  ASSERT_EQ(plan.robots().size(), 2U);
  plan.put_box({rectangle(3.0, 2.0, 3.4, 2.4), {}});
  EXPECT_EQ(plan.walls_besides_robots().size(), 20U);
  plan.put_robots({});
  EXPECT_EQ(plan.walls().size(), 20U);
  EXPECT_EQ(plan.walls_besides_robots().size(), 20U);
}

TEST(FloorPlan, ABoxStandsFromNowOnBeforeThePeople) {
  FloorPlan plan = box_room({pillar});
  const std::vector<Disc> people{{{3.0, 1.0}, 0.2}};
  plan.put_people(people);
  const std::size_t corners = plan.corners().size();
  plan.put_box({rectangle(3.0, 2.0, 3.4, 2.4), {}});
  EXPECT_EQ(plan.still_walls().size(), 12U);
  EXPECT_EQ(plan.first_walls().size(), 8U);
  EXPECT_EQ(plan.walls().size(), 24U) << "the person is still there";
  EXPECT_EQ(plan.walls()[12].surface.material, Material::kRough);
  EXPECT_EQ(plan.corners().size(), corners + 4);
  ASSERT_EQ(plan.boxes_m().size(), 1U);
  EXPECT_EQ(plan.boxes_m()[0], rectangle(3.0, 2.0, 3.4, 2.4));
  EXPECT_FALSE(plan.is_free({3.2, 2.2}));
  EXPECT_NEAR(plan.clearance_m({2.5, 2.2}), 0.5, 1e-12);
  plan.put_people({});
  EXPECT_EQ(plan.walls().size(), 12U);
}

}  // namespace
}  // namespace echomap::world
