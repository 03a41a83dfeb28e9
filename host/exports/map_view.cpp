// SPDX-License-Identifier: MIT
#include "host/exports/map_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace echomap::exports {
namespace {

using mapping::CellState;

constexpr Colour kUnknown{208, 211, 217};
constexpr Colour kUnknownHatch{190, 194, 202};
constexpr int kHatchPeriod = 8;

constexpr int kMinPixelsPerCell = 2;
constexpr int kMaxPixelsPerCell = 8;
constexpr int kWantedSide = 900;
constexpr int kMinWidth = 160;
constexpr int kFooterHeight = 44;
constexpr int kLegendLine = 24;
constexpr int kTextScale = 2;
constexpr int kMargin = 14;
constexpr int kBarThickness = 5;
constexpr int kSwatch = 14;

Colour colour_of(CellState state, int x, int y) {
  switch (state) {
    case CellState::kFree:
      return kFloorColour;
    case CellState::kOccupied:
      return kWallColour;
    case CellState::kUnknown:
      break;
  }
  return (x + y) % kHatchPeriod == 0 ? kUnknownHatch : kUnknown;
}

int legend_width(const std::vector<LegendEntry>& legend) {
  int width = kMinWidth;
  for (const LegendEntry& entry : legend) {
    width = std::max(width, 3 * kMargin + kSwatch + Picture::text_width(entry.text, kTextScale));
  }
  return width;
}

}  // namespace

MapView::MapView(const mapping::RasterMap& map, std::vector<LegendEntry> legend)
    : map_(map),
      legend_(std::move(legend)),
      pixels_per_cell_(std::clamp(
          kWantedSide / std::max(map.columns(), map.rows()), kMinPixelsPerCell, kMaxPixelsPerCell)),
      metres_per_pixel_(map.resolution_m() / pixels_per_cell_),
      width_(map.columns() * pixels_per_cell_),
      left_(std::max(0, (legend_width(legend_) - width_) / 2)) {
  width_ += 2 * left_;
}

int MapView::height() const {
  return map_height() + kFooterHeight + kLegendLine * static_cast<int>(legend_.size());
}

Eigen::Vector2d MapView::place(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d from_origin_m = point_m - map_.origin_m();
  return {left_ + pixels(from_origin_m.x()), map_height() - pixels(from_origin_m.y())};
}

void MapView::fill_cell(Picture& picture, geometry::CellIndex cell, Colour colour) const {
  picture.fill_rectangle(left_ + cell.x * pixels_per_cell_,
                         (map_.rows() - 1 - cell.y) * pixels_per_cell_,
                         pixels_per_cell_,
                         pixels_per_cell_,
                         colour);
}

Picture MapView::draw() const {
  Picture picture(width_, height(), kFloorColour);
  draw_cells(picture);
  draw_scale_bar(picture);
  draw_legend(picture);
  return picture;
}

void MapView::draw_cells(Picture& picture) const {
  for (int y = 0; y < map_height(); ++y) {
    for (int x = 0; x < width_; ++x) {
      const int column = (x - left_) / pixels_per_cell_;
      const int row = map_.rows() - 1 - y / pixels_per_cell_;
      const CellState state = x < left_ ? CellState::kUnknown : map_.state({column, row});
      picture.set(x, y, colour_of(state, x, y));
    }
  }
}

void MapView::draw_scale_bar(Picture& picture) const {
  const double length_m = scale_bar_m(width_ * metres_per_pixel_ / 3.0);
  const int length = static_cast<int>(std::lround(pixels(length_m)));
  const int y = map_height() + kFooterHeight / 2;
  picture.fill_rectangle(kMargin, y - kBarThickness / 2, length, kBarThickness, kInkColour);
  for (const int x : {kMargin, kMargin + length - 2}) {
    picture.fill_rectangle(x, y - 2 * kBarThickness, 2, 4 * kBarThickness, kInkColour);
  }
  picture.draw_text(
      kMargin + length + kMargin, y - 7, length_text(length_m), kTextScale, kInkColour);
}

void MapView::draw_legend(Picture& picture) const {
  int y = map_height() + kFooterHeight;
  for (const LegendEntry& entry : legend_) {
    picture.fill_rectangle(kMargin, y, kSwatch, kSwatch, kInkColour);
    picture.fill_rectangle(kMargin + 1, y + 1, kSwatch - 2, kSwatch - 2, entry.colour);
    picture.draw_text(2 * kMargin + kSwatch, y, entry.text, kTextScale, kInkColour);
    y += kLegendLine;
  }
}

std::vector<PngText> MapView::texts() const {
  const Eigen::Vector2d corner_m =
      map_.origin_m() - metres_per_pixel_ * Eigen::Vector2d(left_, height() - map_height());
  return {{"Software", "echomap"},
          {"resolution", fmt::format("{:.9g}", metres_per_pixel_)},
          {"origin", fmt::format("[{:.9g}, {:.9g}, 0]", corner_m.x(), corner_m.y())}};
}

double scale_bar_m(double longest_m) {
  constexpr std::array kLengthsM{10.0, 5.0, 2.0, 1.0, 0.5, 0.2};
  for (const double length_m : kLengthsM) {
    if (length_m <= longest_m) {
      return length_m;
    }
  }
  return 0.1;
}

std::string length_text(double length_m) { return fmt::format("{:.9g} m", length_m); }

}  // namespace echomap::exports
