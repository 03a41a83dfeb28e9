// SPDX-License-Identifier: MIT
#include "host/evaluation/truth_picture.hpp"

#include <algorithm>
#include <array>

#include "host/evaluation/outline_agreement.hpp"
#include "host/exports/map_view.hpp"
#include "host/geometry/main_direction.hpp"

namespace echomap::evaluation {
namespace {

using exports::Colour;
using geometry::CellIndex;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr Colour kFound{235, 240, 235};

/// The colour of a verdict and its words in the legend.
struct Shown {
  CellVerdict verdict;
  Colour colour;
  const char* text;
};

constexpr std::array<Shown, 6> kShown{{
    {CellVerdict::kFloorFound, kFound, "floor, and it is"},
    {CellVerdict::kWallFound, exports::kWallColour, "wall, and it is"},
    {CellVerdict::kFloorMissed, exports::kSkyBlue, "floor not found"},
    {CellVerdict::kFloorInvented, exports::kVermilion, "called floor, is not"},
    {CellVerdict::kSolidCalledFree, exports::kPurple, "called floor, is solid"},
    {CellVerdict::kWallInvented, exports::kOrange, "called wall, is none"},
}};

const Shown* shown_as(CellVerdict verdict) {
  return std::find_if(
      kShown.begin(), kShown.end(), [&](const Shown& shown) { return shown.verdict == verdict; });
}

std::vector<exports::LegendEntry> legend() {
  std::vector<exports::LegendEntry> entries;
  entries.reserve(kShown.size() + 1);
  for (const Shown& shown : kShown) {
    entries.push_back({shown.colour, shown.text});
  }
  entries.push_back({exports::kGreen, "true walls"});
  return entries;
}

bool has_wall_near(const Eigen::Vector2d& point_m,
                   const std::vector<geometry::Segment>& walls,
                   double reach_m) {
  return std::any_of(walls.begin(), walls.end(), [&](const geometry::Segment& wall) {
    return geometry::distance_m(wall, point_m) <= reach_m;
  });
}

bool is_inside_any(const std::vector<geometry::Polygon>& obstacles,
                   const Eigen::Vector2d& point_m) {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const geometry::Polygon& obstacle) {
    return geometry::contains(obstacle, point_m);
  });
}

std::vector<geometry::Segment> moved(std::vector<geometry::Segment> walls, const Pose2& T) {
  for (geometry::Segment& wall : walls) {
    wall = {T * wall.from_m, T * wall.to_m};
  }
  return walls;
}

std::vector<Eigen::Vector2d> ends_of(const std::vector<geometry::Segment>& walls) {
  std::vector<Eigen::Vector2d> ends_m;
  for (const geometry::Segment& wall : walls) {
    ends_m.insert(ends_m.end(), {wall.from_m, wall.to_m});
  }
  return ends_m;
}

}  // namespace

CellVerdict verdict_on(CellIndex cell,
                       const RasterMap& map,
                       const Pose2& T_world_map,
                       const MapTruth& truth,
                       const std::vector<geometry::Polygon>& obstacles) {
  const Eigen::Vector2d place_m = T_world_map * map.center_m(cell);
  const bool is_floor = truth.cells.state(truth.cells.cell_at(place_m)) == CellState::kFree;
  switch (map.state(cell)) {
    case CellState::kFree:
      if (is_inside_any(obstacles, place_m)) {
        return CellVerdict::kSolidCalledFree;
      }
      return is_floor ? CellVerdict::kFloorFound : CellVerdict::kFloorInvented;
    case CellState::kOccupied:
      return has_wall_near(place_m, truth.walls, wall_reach_m(map)) ? CellVerdict::kWallFound
                                                                    : CellVerdict::kWallInvented;
    case CellState::kUnknown:
      break;
  }
  return is_floor ? CellVerdict::kFloorMissed : CellVerdict::kNothing;
}

void write_truth_picture(const std::filesystem::path& path,
                         const RasterMap& map,
                         const Pose2& T_world_map,
                         const MapTruth& truth,
                         const TruthPictureStyle& style) {
  const mapping::CellBounds cells = cells_of_both(map, T_world_map, truth.cells);
  const RasterMap canvas = mapping::cut_out(map, cells);
  const auto obstacles = obstacle_rings(truth.walls);
  const std::vector<geometry::Segment> walls_m = moved(truth.walls, T_world_map.inverse());
  const exports::MapView view(
      canvas,
      {.legend = legend(),
       .title = style.title,
       .turn_rad = style.align ? geometry::main_direction_rad(walls_m) : 0.0,
       .points_m = ends_of(walls_m),
       .shows_metre_grid = false});
  exports::Picture picture = view.draw();
  for (int y = 0; y < canvas.rows(); ++y) {
    for (int x = 0; x < canvas.columns(); ++x) {
      const CellVerdict verdict =
          verdict_on({cells.min.x + x, cells.min.y + y}, map, T_world_map, truth, obstacles);
      if (const auto* shown = shown_as(verdict); shown != kShown.end()) {
        view.fill_cell(picture, {x, y}, shown->colour);
      }
    }
  }
  for (const geometry::Segment& wall : walls_m) {
    picture.draw_line(view.place(wall.from_m), view.place(wall.to_m), 2.0, exports::kGreen);
  }
  picture.write_png(path, view.texts());
}

}  // namespace echomap::evaluation
