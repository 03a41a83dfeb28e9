// SPDX-License-Identifier: MIT
#include "tests/benchmarks/building_runs.hpp"

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/exports/pgm_image.hpp"

namespace echomap::bench {
namespace {

geometry::Pose2 read_pose(datasets::FieldCursor& fields) {
  const double x_m = fields.number("x");
  const double y_m = fields.number("y");
  return {x_m, y_m, fields.number("theta")};
}

}  // namespace

mapping::RasterMap read_building(const std::filesystem::path& pgm) {
  constexpr std::uint8_t kFree = 254;
  const exports::PgmImage image = exports::read_pgm(pgm);
  mapping::RasterMap map(image.columns, image.rows, 0.05, {0.0, 0.0});
  std::size_t i = 0;
  for (int y = image.rows - 1; y >= 0; --y) {
    for (int x = 0; x < image.columns; ++x, ++i) {
      const std::uint8_t grey = image.pixels[i];
      map.set({x, y},
              grey == 0       ? mapping::CellState::kOccupied
              : grey == kFree ? mapping::CellState::kFree
                              : mapping::CellState::kUnknown);
    }
  }
  return map;
}

BuildingRun read_building_run(const std::filesystem::path& log) {
  datasets::LineReader lines(log);
  datasets::FieldCursor head(lines, lines.next().value_or(""));
  head.skip(1);
  const auto beams = static_cast<std::size_t>(head.integer("beams"));
  head.skip(1);
  BuildingRun run{head.number("rmax"), {}};
  head.skip(1);
  const double aperture_rad = head.number("aperture");
  while (const auto line = lines.next()) {
    datasets::FieldCursor fields(lines, *line);
    BuildingStep step;
    step.T_odom_robot = read_pose(fields);
    step.T_map_robot = read_pose(fields);
    for (std::size_t i = 0; i < beams; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(beams - 1);
      const double range_m = fields.number("range");
      step.readings.push_back({{0.0, 0.0, aperture_rad * (share - 0.5)}, std::nullopt});
      if (range_m < run.max_range_m) {
        step.readings.back().range_m = range_m;
      }
    }
    run.steps.push_back(std::move(step));
  }
  return run;
}

}  // namespace echomap::bench
