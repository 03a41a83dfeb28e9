// SPDX-License-Identifier: MIT
#include "host/apps/map_file.hpp"

#include <algorithm>

#include "host/console/exit_code.hpp"
#include "host/exports/pgm_yaml.hpp"

namespace echomap::apps {
namespace {

bool has_floor(const mapping::RasterMap& map) {
  for (int y = 0; y < map.rows(); ++y) {
    const mapping::CellState* row = map.row(y);
    if (std::find(row, row + map.columns(), mapping::CellState::kFree) != row + map.columns()) {
      return true;
    }
  }
  return false;
}

}  // namespace

mapping::RasterMap read_map(const std::filesystem::path& map) {
  const bool is_run = std::filesystem::is_directory(map);
  mapping::RasterMap raster = exports::read_pgm_yaml(is_run ? map / "map.yaml" : map);
  if (!has_floor(raster)) {
    throw console::CommandError(console::ExitCode::kRuntimeError,
                                map.string() +
                                    " has no floor where a robot fits\n"
                                    "  next: name another map with --map, or explore first");
  }
  return raster;
}

}  // namespace echomap::apps
