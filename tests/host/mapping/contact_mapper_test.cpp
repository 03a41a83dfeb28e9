// SPDX-License-Identifier: MIT
#include "host/mapping/contact_mapper.hpp"

#include <array>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using ::testing::ElementsAre;
using Ranges = std::array<std::optional<double>, 2>;

constexpr double kRightRad = -std::numbers::pi / 2.0;

/// A round body of 0.1 m; sensors look ahead, and aside by `apart_rad`.
ContactMapperParams robot(double apart_rad = kRightRad) {
  ContactMapperParams params;
  params.body_radius_m = 0.1;
  params.T_robot_infrared = {{0.1, 0.0, 0.0}, {0.0, 0.0, apart_rad}};
  params.infrared_reach_m = 0.3;
  return params;
}

tests::DrawnMap drawn(const ContactMapper& mapper) {
  return tests::drawing_of(rasterize(mapper.grid()));
}

TEST(ContactMapper, CallsTheFloorFreeThatTheBodyHasBeenOn) {
  ContactMapper mapper(robot(), {});
  for (double x_m = 0.0; x_m < 0.2; x_m += 0.01) {
    mapper.pass_over({x_m, 0.0, 0.0});
  }
  EXPECT_THAT(drawn(mapper), ElementsAre("        ", " ...... ", " ...... ", "        "));
}

TEST(ContactMapper, ABodyThatStandsSaysItOnce) {
  ContactMapper mapper(robot(), {});
  mapper.pass_over({});
  const auto once = mapper.grid().centilogits({0, 0});
  mapper.pass_over({0.001, 0.0, 0.0});
  EXPECT_EQ(mapper.grid().centilogits({0, 0}), once);
  mapper.pass_over({0.02, 0.0, 0.0});
  EXPECT_LT(mapper.grid().centilogits({0, 0}), once);
}

TEST(ContactMapper, ABumpOfBothSwitchesIsAWallAhead) {
  ContactMapper mapper(robot(), {});
  mapper.bump({0.01, 0.02, 0.0}, true, true);
  EXPECT_THAT(drawn(mapper), ElementsAre("   ", " # ", " # ", " # ", "   "));
  EXPECT_EQ(mapper.grid().bounds().min, (geometry::CellIndex{2, -1}));
}

TEST(ContactMapper, ABumpOfOneSwitchIsOnItsSide) {
  for (const bool left : {false, true}) {
    ContactMapper mapper(robot(), {});
    mapper.bump({}, left, !left);
    const CellBounds& bounds = mapper.grid().bounds();
    ASSERT_FALSE(bounds.empty());
    EXPECT_EQ(mapper.grid().state(mapper.grid().cell_at({0.076, left ? 0.064 : -0.064})),
              CellState::kOccupied);
    EXPECT_TRUE(left ? bounds.min.y >= 0 : bounds.max.y < 0);
  }
}

TEST(ContactMapper, ASwitchThatOpensSaysNothing) {
  ContactMapper mapper(robot(), {});
  mapper.bump({}, false, false);
  EXPECT_TRUE(mapper.grid().bounds().empty());
}

TEST(ContactMapper, KnowsNothingOfABodyWithoutASize) {
  ContactMapperParams params = robot();
  params.body_radius_m = 0.0;
  ContactMapper mapper(params, {});
  mapper.pass_over({});
  mapper.bump({}, true, true);
  EXPECT_TRUE(mapper.grid().bounds().empty());
}

TEST(ContactMapper, SeesWallsAndTheFloorBeforeThem) {
  ContactMapper mapper(robot(), {});
  for (int i = 0; i < 10; ++i) {
    mapper.add_ranges({0.0, 0.025, 0.0}, Ranges{0.17, 0.08});
  }
  EXPECT_THAT(drawn(mapper),
              ElementsAre("        ", " . ...# ", " .      ", " #      ", "        "));
}

TEST(ContactMapper, WhereNothingAnswersAllIsFreeAsFarAsASensorSees) {
  ContactMapper mapper(robot(), {});
  for (int i = 0; i < 20; ++i) {
    mapper.add_ranges({0.0, 0.025, 0.0}, Ranges{std::nullopt, std::nullopt});
  }
  const auto& grid = mapper.grid();
  EXPECT_EQ(grid.state(grid.cell_at({0.38, 0.025})), CellState::kFree);
  EXPECT_EQ(grid.state(grid.cell_at({0.0, -0.25})), CellState::kFree);
  EXPECT_FALSE(grid.probability(grid.cell_at({0.46, 0.025})));
}

TEST(ContactMapper, TheFartherOfTwoAnswersOfOneWallIsNoWall) {
  const auto is_wall = [](double apart_rad, const Ranges& range_m) {
    ContactMapper mapper(robot(apart_rad), {});
    mapper.add_ranges({0.0, 0.025, 0.0}, range_m);
    return mapper.grid().state(mapper.grid().cell_at({0.1 + 0.17, 0.025})) == CellState::kOccupied;
  };
  EXPECT_FALSE(is_wall(-0.8, {0.17, 0.08}));
  EXPECT_TRUE(is_wall(-0.8, {0.17, 0.25}));
  EXPECT_TRUE(is_wall(-0.8, {0.17, std::nullopt}));
  EXPECT_TRUE(is_wall(kRightRad, {0.17, 0.08})) << "it looks aside, at another wall";
}

TEST(ContactMapper, RefusesWhatHasNoSense) {
  ContactMapperParams params = robot();
  params.infrared_reach_m = 0.0;
  EXPECT_THROW(ContactMapper(params, {}), std::invalid_argument);
  params = robot();
  params.body_radius_m = -0.1;
  EXPECT_THROW(ContactMapper(params, {}), std::invalid_argument);
  params = robot();
  params.silent_centilogits = 10;
  EXPECT_THROW(ContactMapper(params, {}), std::invalid_argument);
}

TEST(WithContactEvidence, WhatIsNearOutweighsWhatIsFar) {
  OccupancyGrid far;
  OccupancyGrid near;
  far.add({0, 0}, -500);
  far.add({1, 0}, 500);
  far.add({2, 0}, -500);
  near.add({0, 0}, 294);
  near.add({1, 0}, -400);
  near.add({3, 0}, 294);
  const OccupancyGrid both = with_contact_evidence(far, near);
  EXPECT_EQ(both.state({0, 0}), CellState::kOccupied);
  EXPECT_EQ(both.state({1, 0}), CellState::kFree);
  EXPECT_EQ(both.centilogits({2, 0}), -500) << "nothing near is known of it";
  EXPECT_EQ(both.centilogits({3, 0}), near.centilogits({3, 0}));
}

}  // namespace
}  // namespace echomap::mapping
