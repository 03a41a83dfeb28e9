// SPDX-License-Identifier: MIT
#include "host/papers/epuck_grid_picture.hpp"

#include "host/exports/map_view.hpp"
#include "host/papers/epuck_field.hpp"
#include "host/papers/picture_file.hpp"

namespace echomap::papers {
namespace {

constexpr exports::Colour kShadeOccupied{255, 255, 255};
constexpr exports::Colour kShadeUnknown{128, 128, 128};
constexpr exports::Colour kShadeFree{0, 0, 0};

exports::Colour shade_of(mapping::CellState state) {
  switch (state) {
    case mapping::CellState::kOccupied:
      return kShadeOccupied;
    case mapping::CellState::kFree:
      return kShadeFree;
    case mapping::CellState::kUnknown:
      break;
  }
  return kShadeUnknown;
}

}  // namespace

std::vector<std::uint8_t> draw_in_shades(const std::filesystem::path& file,
                                         const mapping::RasterMap& map) {
  const exports::MapView view(
      map,
      {.legend = {{kShadeOccupied, "obstacle"}, {kShadeFree, "free"}, {kShadeUnknown, "unknown"}},
       .shows_metre_grid = false});
  exports::Picture picture = view.draw();
  for (geometry::CellIndex cell{0, 0}; cell.y < map.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < map.columns(); ++cell.x) {
      view.fill_cell(picture, cell, shade_of(map.state(cell)));
    }
  }
  return write_picture(picture, file, view.texts());
}

std::vector<std::uint8_t> draw_under_walls(const std::filesystem::path& file,
                                           const mapping::RasterMap& map) {
  const exports::MapView view(map, {.legend = {{exports::kVermilion, "true walls"}}});
  exports::Picture picture = view.draw();
  for (const world::Wall& wall : epuck_field().walls()) {
    picture.draw_line(
        view.place(wall.segment.from_m), view.place(wall.segment.to_m), 1.0, exports::kVermilion);
  }
  return write_picture(picture, file, view.texts());
}

}  // namespace echomap::papers
