// SPDX-License-Identifier: MIT
#include "host/papers/room_floor.hpp"

#include <cmath>

#include "hil_mock/world/floor_plan_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::papers {

world::FloorPlan bundled_room(const std::string& name) {
  return world::read_floor_plan(
      files::TomlReader::load(files::bundled_file(name, "hil_mock/worlds", "world")));
}

Box box_around(const world::FloorPlan& room) {
  Box box{room.room_m().front(), room.room_m().front()};
  for (const Eigen::Vector2d& corner_m : room.room_m()) {
    box.low_m = box.low_m.cwiseMin(corner_m);
    box.high_m = box.high_m.cwiseMax(corner_m);
  }
  return box;
}

mapping::RasterMap floor_of(const world::FloorPlan& room, double cell_m, double margin_m) {
  const Box box = box_around(room);
  const Eigen::Vector2d low_m = box.low_m.array() - margin_m;
  const Eigen::Vector2d cells = (box.high_m.array() + margin_m - low_m.array()) / cell_m;
  mapping::RasterMap floor(static_cast<int>(std::ceil(cells.x())),
                           static_cast<int>(std::ceil(cells.y())),
                           cell_m,
                           low_m);
  for (geometry::CellIndex cell{0, 0}; cell.y < floor.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < floor.columns(); ++cell.x) {
      if (room.is_free(floor.center_m(cell))) {
        floor.set(cell, mapping::CellState::kFree);
      }
    }
  }
  return floor;
}

}  // namespace echomap::papers
