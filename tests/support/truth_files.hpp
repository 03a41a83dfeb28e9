// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/exports/pgm_yaml.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::tests {

/// The truth of a robot that drove 1 m along +x in 10 s, in a room of 2 m x 1 m, as a mock writes
/// it. The start is at (0.5, 0.5).
inline void write_truth_files(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const DrawnMap room(11, std::string(20, '.'));
  exports::write_pgm_yaml(folder / "truth_map.yaml", map_from(room, 0.1));
  files::write_text_file(folder / "truth_walls.geojson",
                         R"({"type": "FeatureCollection", "features": [
                           {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
                            "coordinates": [[0, 0], [2, 0], [2, 1.1], [0, 1.1], [0, 0]]}},
                           {"type": "Feature", "properties": {}, "geometry": {"type": "Point",
                            "coordinates": [0.5, 0.5]}}]})");
  files::write_text_file(folder / "truth.tum",
                         "0.000000 0.5 0.5 0 0 0 0 1\n10.000000 1.5 0.5 0 0 0 0 1\n");
}

}  // namespace echomap::tests
