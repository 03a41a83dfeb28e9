// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/evaluation/map_agreement.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::evaluation {

/// What a map says of a cell, and whether it is so.
enum class CellVerdict : std::uint8_t {
  kNothing,          ///< Unknown, and no floor that could be seen.
  kFloorFound,       ///< Free, and it is.
  kWallFound,        ///< Occupied, with a wall within 5 cm, or one cell if that is larger.
  kFloorMissed,      ///< Unknown or occupied, but floor.
  kFloorInvented,    ///< Free, but no floor; outside of the obstacles.
  kWallInvented,     ///< Occupied, and no wall is near.
  kSolidCalledFree,  ///< Free, but inside of an obstacle.
};

/// Judges a cell of the map by its centre. `cell` may lie outside of it; `obstacles` are the
/// truth's `obstacle_rings`.
CellVerdict verdict_on(geometry::CellIndex cell,
                       const mapping::RasterMap& map,
                       const geometry::Pose2& T_world_map,
                       const MapTruth& truth,
                       const std::vector<geometry::Polygon>& obstacles);

/// How a picture of a map on its truth is drawn.
struct TruthPictureStyle {
  std::string title{};
  bool align = true;  ///< Turned to the main direction of the true walls.
};

/// Draws the map in the colours of its verdicts, with the true walls as lines, a title, a legend
/// and a scale bar, as PNG. Throws files::FileError, and std::invalid_argument where map and truth
/// lie so far apart that no picture can hold both.
void write_truth_picture(const std::filesystem::path& path,
                         const mapping::RasterMap& map,
                         const geometry::Pose2& T_world_map,
                         const MapTruth& truth,
                         const TruthPictureStyle& style = {});

}  // namespace echomap::evaluation
