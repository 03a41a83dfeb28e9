// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// Of the layout that write_map_json writes. A reader that finds another one should stop.
constexpr int kMapJsonVersion = 1;

/// map.json, the whole map for programs, as one JSON object:
///
/// - `format` ("echomap-map"), `version`, `frame`, `units`: how to read the rest. All is in metres,
///   radians and seconds of the map frame.
/// - `resolution_m`, `origin_m` (lower left corner), `rows`, `columns`, `cells`: the occupancy
///   grid, row by row, the top row (largest y) first as in occupancy_grid.csv. A cell is its
///   probability of being occupied to three decimals, null where it is unknown.
/// - `outline`: null, or `corners_m` counter-clockwise, `holes_m` clockwise and `area_m2`.
/// - `walls`, `obstacles`: fitted lines (`from_m`, `to_m`) and circles (`center_m`, `radius_m`).
/// - `start`, `robot`: the first pose of the trajectory (null without one) and the last.
/// - `stops`: the pose at each stop whose readings are in the grid, and how many they are.
/// - `trajectory`: rows of `t_s`, `x_m`, `y_m`, `heading_rad`, as the key `trajectory_columns`
/// says.
/// - `free_area_m2`: the cells known to be free, together.
///
/// The file has one key, one row of cells or one pose a line. Throws files::FileError.
void write_map_json(const std::filesystem::path& path,
                    const pipeline::Snapshot& snapshot,
                    const std::optional<mapping::PolygonMap>& outline);

}  // namespace echomap::exports
