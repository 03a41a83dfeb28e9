// SPDX-License-Identifier: MIT
#include "host/papers/epuck_grid_picture.hpp"

#include <gtest/gtest.h>

#include "host/papers/epuck_field.hpp"
#include "host/papers/room_floor.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(EpuckGridPicture, IsWrittenAndShowsTheCells) {
  const tests::ScratchFolder folder;
  mapping::RasterMap map = floor_of(epuck_field(), 0.01, 0.0);
  const auto shades = draw_in_shades(folder / "sub/shades.png", map);
  const auto walls = draw_under_walls(folder / "walls.png", map);
  EXPECT_EQ(shades.size(), file_size(folder / "sub/shades.png"));
  EXPECT_EQ(walls.size(), file_size(folder / "walls.png"));
  EXPECT_NE(shades, walls);
  map.set({20, 30}, mapping::CellState::kOccupied);
  EXPECT_NE(draw_in_shades(folder / "again.png", map), shades);
  EXPECT_NE(draw_under_walls(folder / "again.png", map), walls);
}

}  // namespace
}  // namespace echomap::papers
