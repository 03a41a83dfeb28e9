// SPDX-License-Identifier: MIT
#include "hil_mock/world/source_field.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "hil_mock/world/floor_plan.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

constexpr double kHeightM = 0.1;

/// Two rooms of 3 m with a wall of 20 cm and a door of 1 m between them, a source in the left one.
FloorPlan two_rooms(SourceKind kind, double room_per_m, std::vector<Outline> obstacles = {}) {
  FloorMarks marks;
  marks.sources = {{kind, {1.0, 0.5}, 20.0, kHeightM}};
  marks.backgrounds = {0.5, 3.0};
  const Polygon corners_m{{0.0, 0.0},
                          {3.0, 0.0},
                          {3.0, 2.0},
                          {3.2, 2.0},
                          {3.2, 0.0},
                          {6.2, 0.0},
                          {6.2, 3.0},
                          {0.0, 3.0}};
  return {"two", {corners_m, {}, room_per_m}, std::move(obstacles), {0.5, 2.5, 0.0}, marks};
}

double source_part(const FloorPlan& plan, const Eigen::Vector2d& at_m) {
  return field_at(plan, SourceKind::kRadiation, at_m) - 0.5;
}

TEST(SourceField, FallsWithTheSquareOfTheDistance) {
  const FloorPlan plan = two_rooms(SourceKind::kRadiation, 10.0);
  EXPECT_NEAR(source_part(plan, {2.0, 0.5}), 20.0 / (1.0 + kHeightM * kHeightM), 1e-9);
  EXPECT_NEAR(source_part(plan, {1.0, 2.5}), 20.0 / (4.0 + kHeightM * kHeightM), 1e-9);
  EXPECT_NEAR(source_part(plan, {1.0, 0.5}), 20.0 / (kHeightM * kHeightM), 1e-9);
}

TEST(SourceField, IsWeakenedByTheWallBetween) {
  const FloorPlan plan = two_rooms(SourceKind::kRadiation, 10.0);
  const Eigen::Vector2d straight_m(5.0, 0.5);
  EXPECT_NEAR(optical_depth(plan, {1.0, 0.5}, straight_m), 10.0 * 0.2, 1e-9);
  EXPECT_NEAR(source_part(plan, straight_m), 20.0 / 16.01 * std::exp(-2.0), 1e-9);
  const Eigen::Vector2d askew_m(5.0, 1.5);
  EXPECT_NEAR(optical_depth(plan, {1.0, 0.5}, askew_m), 2.0 * std::hypot(4.0, 1.0) / 4.0, 1e-9);
  const Eigen::Vector2d door_m(5.2, 2.95);
  EXPECT_LT(optical_depth(plan, {1.0, 1.95}, door_m), 1e-9) << "through the door";
}

TEST(SourceField, IsWeakenedByObstaclesEachByItsOwn) {
  const Polygon lead_m{{1.5, 0.4}, {1.6, 0.4}, {1.6, 0.6}, {1.5, 0.6}};
  const Polygon card_m{{2.0, 0.4}, {2.5, 0.4}, {2.5, 0.6}, {2.0, 0.6}};
  FloorPlan plan =
      two_rooms(SourceKind::kRadiation, 10.0, {{lead_m, {}, 100.0}, {card_m, {}, 0.0}});
  EXPECT_NEAR(optical_depth(plan, {1.0, 0.5}, {2.8, 0.5}), 10.0, 1e-9);
  EXPECT_NEAR(optical_depth(plan, {1.0, 0.5}, {1.55, 0.5}), 5.0, 1e-9) << "up to the middle of it";
  plan.put_box({{{2.6, 0.4}, {2.7, 0.4}, {2.7, 0.6}, {2.6, 0.6}}, {}, 3.0});
  EXPECT_NEAR(optical_depth(plan, {1.0, 0.5}, {2.8, 0.5}), 10.3, 1e-9);
}

TEST(SourceField, OfLightEndsAtTheFirstWall) {
  const FloorPlan plan = two_rooms(SourceKind::kLight, 0.0);
  EXPECT_NEAR(field_at(plan, SourceKind::kLight, {2.0, 0.5}), 3.0 + 20.0 / 1.01, 1e-9);
  EXPECT_EQ(field_at(plan, SourceKind::kLight, {5.0, 0.5}), 3.0);
  EXPECT_EQ(field_at(plan, SourceKind::kRadiation, {2.0, 0.5}), 0.5) << "a lamp does not radiate";
}

TEST(SourceField, SourcesOfRadiationCanBeOthers) {
  const FloorPlan plan = two_rooms(SourceKind::kRadiation, 10.0);
  const FloorPlan none = plan.with_radiation(parse_sources({"none"}));
  EXPECT_TRUE(none.sources().empty());
  EXPECT_EQ(field_at(none, SourceKind::kRadiation, {2.0, 0.5}), 0.5);
  const FloorPlan two = plan.with_radiation(parse_sources({"5,1.5,30", " 5.5,2,1e1 "}));
  ASSERT_EQ(two.sources().size(), 2U);
  EXPECT_EQ(two.sources()[1].strength, 10.0);
  EXPECT_THROW(plan.with_radiation(parse_sources({"3.1,1,5"})), std::invalid_argument)
      << "it is in the wall";
  const FloorPlan lamp = two_rooms(SourceKind::kLight, 0.0).with_radiation({});
  EXPECT_EQ(lamp.sources().size(), 1U);
}

TEST(SourceField, RefusesWordsThatAreNoSource) {
  for (const char* const text :
       {"", "1,2", "1,2,0", "1,2,-3", "1;2;3", "1,2,3,4", "a,b,c", "nan"}) {
    EXPECT_THROW(parse_sources({text}), std::invalid_argument) << text;
  }
  EXPECT_THROW(parse_sources({"none", "1,2,3"}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::world
