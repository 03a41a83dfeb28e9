// SPDX-License-Identifier: MIT
#include "host/apps/map_file.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "host/apps/recorded_run.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/shell_line.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/files/atomic_file.hpp"
#include "host/localization/polygon_view.hpp"

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

/// What a folder without map.yaml is, and what to type.
std::string why_no_map(const std::filesystem::path& folder) {
  const std::string none = folder.string() + " has no map.yaml: it is ";
  if (const auto recording = recording_of(folder)) {
    return none + "a recording without a map\n  next: " +
           console::shell_line(
               {"echomap", "replay", folder.string(), "--out", folder.string() + "_map"});
  }
  const std::filesystem::path truth = folder / "truth_map.yaml";
  if (std::filesystem::exists(truth)) {
    return none + "the truth of a simulated robot\n  next: name the run's folder, or the file " +
           truth.string();
  }
  return none +
         "not the folder of a run\n  next: name the one that explore, demo or replay has written "
         "(--out)";
}

/// Of a robot that has followed its walls: the grid has only the floor along them, the outline all
/// of it. Empty where the strategy drew none.
std::optional<mapping::PolygonMap> outline_by_strategy(const std::filesystem::path& run) {
  const auto summary = run / "summary.json";
  const auto outline = run / "outline.geojson";
  if (!exists(summary) || !exists(outline)) {
    return std::nullopt;
  }
  const auto json = nlohmann::json::parse(files::read_text_file(summary), nullptr, false);
  const bool is_drawn =
      json.is_object() && json.value("outline_by_strategy", nlohmann::json()) == true;
  return is_drawn ? exports::read_outline_geojson(outline) : std::nullopt;
}

mapping::RasterMap read_raster(const std::filesystem::path& map) {
  constexpr double kOutlineCellM = 0.01;
  const auto outline = outline_by_strategy(map);
  return outline ? localization::rasterize(*outline, kOutlineCellM)
                 : exports::read_pgm_yaml(map_file_of(map));
}

}  // namespace

std::filesystem::path map_file_of(const std::filesystem::path& map) {
  if (!std::filesystem::is_directory(map)) {
    return map;
  }
  std::filesystem::path file = map / "map.yaml";
  if (!std::filesystem::exists(file)) {
    throw console::CommandError(console::ExitCode::kRuntimeError, why_no_map(map));
  }
  return file;
}

mapping::RasterMap read_map(const std::filesystem::path& map) {
  mapping::RasterMap raster = read_raster(map);
  if (!has_floor(raster)) {
    throw console::CommandError(console::ExitCode::kRuntimeError,
                                map.string() +
                                    " has no floor where a robot fits\n"
                                    "  next: name another map with --map, or explore first");
  }
  return raster;
}

}  // namespace echomap::apps
