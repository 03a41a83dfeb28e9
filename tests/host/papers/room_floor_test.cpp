// SPDX-License-Identifier: MIT
#include "host/papers/room_floor.hpp"

#include <gtest/gtest.h>

#include "host/papers/contact_localization.hpp"

namespace echomap::papers {
namespace {

TEST(RoomFloor, IsFreeInsideAndUnknownOutsideAndInTheMargin) {
  const auto floor = floor_of(contact_room(), 0.0625, 0.25);
  EXPECT_EQ(floor.columns(), 56);
  EXPECT_EQ(floor.rows(), 50);
  const auto state = [&](double x_m, double y_m) { return floor.state(floor.cell_at({x_m, y_m})); };
  EXPECT_EQ(state(1.0, 1.0), mapping::CellState::kFree);
  EXPECT_EQ(state(2.8, 2.2), mapping::CellState::kUnknown) << "behind the reflex corner";
  EXPECT_EQ(state(-0.1, 1.0), mapping::CellState::kUnknown) << "the margin";
}

TEST(RoomFloor, ItsBoxHasShares) {
  const Box box = box_around(contact_room());
  EXPECT_EQ(box.at(0.0, 0.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(box.at(0.5, 1.0), Eigen::Vector2d(1.5, 2.6));
}

TEST(RoomFloor, RoomsComeWithThePrograms) {
  EXPECT_EQ(bundled_room("epuck_field").obstacles_m().size(), 2U);
  EXPECT_ANY_THROW(bundled_room("no_such_room"));
}

}  // namespace
}  // namespace echomap::papers
