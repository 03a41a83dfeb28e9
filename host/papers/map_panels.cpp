// SPDX-License-Identifier: MIT
#include "host/papers/map_panels.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "host/exports/map_view.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/papers/picture_file.hpp"

namespace echomap::papers {
namespace {

using geometry::Segment;

constexpr int kGutterCells = 20;
constexpr int kMinEnds = 3;

Eigen::AlignedBox2d box_of(const MapPanel& panel) {
  Eigen::AlignedBox2d box;
  const auto extend = [&](const std::vector<Segment>& segments) {
    for (const Segment& segment : segments) {
      box.extend(segment.from_m).extend(segment.to_m);
    }
  };
  for (const Eigen::Vector2d& end_m : panel.ends_m) {
    box.extend(end_m);
  }
  for (const geometry::Pose2& pose : panel.path) {
    box.extend(pose.position_m());
  }
  for (const Eigen::Vector2d& point_m : panel.points_m) {
    box.extend(point_m);
  }
  extend(panel.walls);
  extend(panel.true_walls);
  if (box.isEmpty()) {
    throw std::invalid_argument("map panels: a panel has nothing to draw");
  }
  return box;
}

/// A panel and the columns of the picture's cells that it takes.
class PlacedPanel {
 public:
  PlacedPanel(const MapPanel& panel, double cell_m, int first_column)
      : panel_(&panel), box_(box_of(panel)), cell_m_(cell_m), first_column_(first_column) {
    const Eigen::Vector2d cells = box_.sizes() / cell_m;
    columns_ = static_cast<int>(cells.x()) + 1;
    rows_ = static_cast<int>(cells.y()) + 1;
  }

  int rows() const { return rows_; }
  int end_column() const { return first_column_ + columns_; }
  void fill_cells(mapping::RasterMap& map) const;
  void draw(const exports::MapView& view, exports::Picture& picture) const;

 private:
  /// A point of the panel in the picture's map.
  Eigen::Vector2d place_m(const Eigen::Vector2d& point_m) const {
    return point_m - box_.min() + Eigen::Vector2d(first_column_ * cell_m_, 0.0);
  }

  const MapPanel* panel_;
  Eigen::AlignedBox2d box_;
  double cell_m_;
  int first_column_;
  int columns_ = 0;
  int rows_ = 0;
};

void PlacedPanel::fill_cells(mapping::RasterMap& map) const {
  std::vector<int> ends(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (const Eigen::Vector2d& end_m : panel_->ends_m) {
    const Eigen::Vector2i cell = ((end_m - box_.min()) / cell_m_).cast<int>();
    ++ends[static_cast<std::size_t>(cell.y() * columns_ + cell.x())];
  }
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      const bool is_wall = ends[static_cast<std::size_t>(y * columns_ + x)] >= kMinEnds;
      map.set({first_column_ + x, y},
              is_wall ? mapping::CellState::kOccupied : mapping::CellState::kFree);
    }
  }
}

void PlacedPanel::draw(const exports::MapView& view, exports::Picture& picture) const {
  const auto draw_segments = [&](const std::vector<Segment>& segments, exports::Colour colour) {
    for (const Segment& segment : segments) {
      picture.draw_line(
          view.place(place_m(segment.from_m)), view.place(place_m(segment.to_m)), 2.5, colour);
    }
  };
  draw_segments(panel_->true_walls, exports::kWallColour);
  for (std::size_t i = 1; i < panel_->path.size(); ++i) {
    picture.draw_line(view.place(place_m(panel_->path[i - 1].position_m())),
                      view.place(place_m(panel_->path[i].position_m())),
                      2.0,
                      exports::kGreen);
  }
  draw_segments(panel_->walls, exports::kVermilion);
  for (const Eigen::Vector2d& point_m : panel_->points_m) {
    picture.fill_disc(view.place(place_m(point_m)), 3.5, exports::kBlue);
  }
}

}  // namespace

std::vector<std::uint8_t> draw_panels(const std::filesystem::path& file,
                                      const std::vector<MapPanel>& panels,
                                      double cell_m) {
  std::vector<PlacedPanel> placed;
  int columns = 0;
  int rows = 1;
  for (const MapPanel& panel : panels) {
    const int first_column = placed.empty() ? 0 : columns + kGutterCells;
    columns = placed.emplace_back(panel, cell_m, first_column).end_column();
    rows = std::max(rows, placed.back().rows());
  }
  mapping::RasterMap map(columns, rows, cell_m, {0.0, 0.0});
  for (const PlacedPanel& panel : placed) {
    panel.fill_cells(map);
  }
  const exports::MapView view(map,
                              {.legend = {{exports::kGreen, "path"},
                                          {exports::kVermilion, "wall landmarks"},
                                          {exports::kBlue, "point landmarks"}}});
  exports::Picture picture = view.draw();
  view.limit_to_map(picture);
  for (const PlacedPanel& panel : placed) {
    panel.draw(view, picture);
  }
  return write_picture(picture, file, view.texts());
}

}  // namespace echomap::papers
