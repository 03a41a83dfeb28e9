// SPDX-License-Identifier: MIT
#include "host/exports/pgm_yaml.hpp"

#include <string>
#include <vector>

#include "host/exports/map_yaml.hpp"
#include "host/exports/pgm_image.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

using mapping::CellState;
using mapping::RasterMap;

constexpr std::uint8_t kFreePixel = 254;
constexpr std::uint8_t kOccupiedPixel = 0;
constexpr std::uint8_t kUnknownPixel = 205;

std::uint8_t pixel_of(CellState state) {
  switch (state) {
    case CellState::kFree:
      return kFreePixel;
    case CellState::kOccupied:
      return kOccupiedPixel;
    case CellState::kUnknown:
      break;
  }
  return kUnknownPixel;
}

/// As Nav2 and map_server do it: darker than one threshold, no darker than the other.
CellState state_of(std::uint8_t pixel, const MapYaml& yaml) {
  const double darkness = (yaml.negate ? pixel : 255 - pixel) / 255.0;
  if (darkness > yaml.occupied_threshold) {
    return CellState::kOccupied;
  }
  return darkness <= yaml.free_threshold ? CellState::kFree : CellState::kUnknown;
}

}  // namespace

void write_pgm_yaml(const std::filesystem::path& yaml_path, const RasterMap& map) {
  PgmImage image{map.columns(), map.rows(), {}};
  for (int row = map.rows() - 1; row >= 0; --row) {
    for (int column = 0; column < map.columns(); ++column) {
      image.pixels.push_back(pixel_of(map.state({column, row})));
    }
  }
  auto image_path = yaml_path;
  image_path.replace_extension(".pgm");
  write_pgm(image_path, image);
  MapYaml yaml;
  yaml.image = image_path.filename().string();
  yaml.resolution_m = map.resolution_m();
  yaml.origin_m = map.origin_m();
  write_map_yaml(yaml_path, yaml);
}

RasterMap read_pgm_yaml(const std::filesystem::path& yaml_path) {
  const MapYaml yaml = read_map_yaml(yaml_path);
  const PgmImage image = read_pgm(yaml_path.parent_path() / yaml.image);
  RasterMap map(image.columns, image.rows, yaml.resolution_m, yaml.origin_m);
  auto pixel = image.pixels.begin();
  for (int row = map.rows() - 1; row >= 0; --row) {
    for (int column = 0; column < map.columns(); ++column) {
      map.set({column, row}, state_of(*pixel++, yaml));
    }
  }
  return map;
}

}  // namespace echomap::exports
