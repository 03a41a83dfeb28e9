// SPDX-License-Identifier: MIT
#include "host/papers/confidence_picture.hpp"

#include <algorithm>
#include <cmath>

#include "host/exports/map_view.hpp"
#include "host/papers/picture_file.hpp"

namespace echomap::papers {

namespace {

exports::Colour heat(double confidence) {
  const double share = std::clamp(std::log1p(confidence) / std::log(200.0), 0.0, 1.0);
  const auto mix = [&](double from, double to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(250.0, 60.0), mix(225.0, 20.0), mix(120.0, 0.0)};
}

}  // namespace

std::vector<std::uint8_t> draw_confidence(const std::filesystem::path& path,
                                          const mapping::CellField& confidence,
                                          const world::FloorPlan& room,
                                          const std::vector<Eigen::Vector2d>& path_m) {
  std::vector<exports::LegendEntry> legend{{heat(1.0), "confidence 1"},
                                           {heat(20.0), "confidence 20"},
                                           {exports::kVermilion, "true walls"}};
  if (!path_m.empty()) {
    legend.push_back({exports::kBlue, "the path driven"});
  }
  const exports::MapView view(mapping::RasterMap(confidence.bounds().columns(),
                                                 confidence.bounds().rows(),
                                                 confidence.resolution_m(),
                                                 {0, 0}),
                              {.legend = legend, .shows_metre_grid = false});
  exports::Picture picture = view.draw();
  for (std::size_t i = 0; i < confidence.size(); ++i) {
    view.fill_cell(picture,
                   confidence.cell(i),
                   confidence[i] < 0.05F ? exports::Colour{205, 222, 240} : heat(confidence[i]));
  }
  for (const world::Wall& wall : room.walls()) {
    picture.draw_line(
        view.place(wall.segment.from_m), view.place(wall.segment.to_m), 1.5, exports::kVermilion);
  }
  for (std::size_t i = 1; i < path_m.size(); ++i) {
    picture.draw_line(view.place(path_m[i - 1]), view.place(path_m[i]), 1.5, exports::kBlue);
  }
  return write_picture(picture, path, view.texts());
}

}  // namespace echomap::papers
