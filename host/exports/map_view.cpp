// SPDX-License-Identifier: MIT
#include "host/exports/map_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace echomap::exports {
namespace {

using mapping::CellState;

constexpr Colour kUnknownHatch{190, 194, 202};
constexpr int kHatchPeriod = 8;

constexpr int kMinPixelsPerCell = 2;
constexpr int kMaxPixelsPerCell = 8;
constexpr int kWantedSide = 900;
/// A picture that would be larger has less than a pixel for a cell.
constexpr int kMaxSide = 8000;
constexpr int kMinWidth = 160;
constexpr int kFooterHeight = 44;
constexpr int kHeaderHeight = 30;
constexpr int kLegendLine = 24;
constexpr int kTextScale = 2;
constexpr int kMargin = 14;
constexpr int kBarThickness = 5;
constexpr int kSwatch = 14;

Colour colour_of(CellState state, int x, int y, bool is_on_grid) {
  if (state == CellState::kOccupied) {
    return kWallColour;
  }
  if (is_on_grid) {
    return kGridColour;
  }
  if (state == CellState::kFree) {
    return kFloorColour;
  }
  return (x + y) % kHatchPeriod == 0 ? kUnknownHatch : kUnknownColour;
}

/// Of the widest entry, with its swatch and the margins.
int legend_width(const std::vector<LegendEntry>& legend) {
  int width = 0;
  for (const LegendEntry& entry : legend) {
    width = std::max(width, 3 * kMargin + kSwatch + Picture::text_width(entry.text, kTextScale));
  }
  return width;
}

int min_width(const MapViewParams& params) {
  return std::max({kMinWidth,
                   legend_width(params.legend),
                   2 * kMargin + Picture::text_width(params.title, kTextScale)});
}

/// Whole pixels for a cell, where `max_width_px` leaves at least one.
double metres_per_pixel(const PictureFrame& frame,
                        double cell_m,
                        const std::optional<int>& max_width_px) {
  const int cells = static_cast<int>(std::lround(frame.size_m.maxCoeff() / cell_m));
  int pixels_per_cell = std::clamp(kWantedSide / cells, kMinPixelsPerCell, kMaxPixelsPerCell);
  double min_m = frame.size_m.maxCoeff() / kMaxSide;
  if (max_width_px) {
    const int columns = static_cast<int>(std::lround(frame.size_m.x() / cell_m));
    pixels_per_cell = std::clamp(*max_width_px / columns, 1, pixels_per_cell);
    min_m = std::max(min_m, frame.size_m.x() / *max_width_px);
  }
  return std::max(cell_m / pixels_per_cell, min_m);
}

}  // namespace

MapView::MapView(const mapping::RasterMap& map, MapViewParams params)
    : map_(map),
      params_(std::move(params)),
      frame_(params_.frame ? *params_.frame : frame_of(map_, params_.turn_rad, params_.points_m)),
      metres_per_pixel_(metres_per_pixel(frame_, map_.resolution_m(), params_.max_map_width_px)),
      width_(static_cast<int>(std::lround(pixels(frame_.size_m.x())))),
      left_(std::max(0, (min_width(params_) - width_) / 2)),
      top_(params_.title.empty() ? 0 : kHeaderHeight) {
  width_ += 2 * left_;
}

int MapView::map_height() const { return static_cast<int>(std::lround(pixels(frame_.size_m.y()))); }

int MapView::legend_columns() const {
  return std::max(1, width_ / std::max(1, legend_width(params_.legend)));
}

int MapView::height() const {
  const int entries = static_cast<int>(params_.legend.size());
  const int lines = (entries + legend_columns() - 1) / legend_columns();
  return map_bottom() + kFooterHeight + kLegendLine * lines;
}

std::size_t MapView::title_letters(int width_px) {
  return static_cast<std::size_t>((width_px - 2 * kMargin) / Picture::text_width(" ", kTextScale));
}

Eigen::Vector2d MapView::place(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d from_low_m = frame_.in_picture_m(point_m) - frame_.low_m;
  return {left_ + pixels(from_low_m.x()), map_bottom() - pixels(from_low_m.y())};
}

geometry::CellIndex MapView::cell_at(int x, int y) const {
  const Eigen::Vector2d from_low_m =
      metres_per_pixel_ * Eigen::Vector2d(x + 0.5 - left_, map_bottom() - y - 0.5);
  return map_.cell_at(frame_.in_map_m(frame_.low_m + from_low_m));
}

void MapView::fill_cell(Picture& picture, geometry::CellIndex cell, Colour colour) const {
  const Eigen::Vector2d middle = place(map_.center_m(cell));
  const double reach = 0.75 * pixels(map_.resolution_m()) + 1.0;
  const Eigen::Vector2d low = middle.array() - reach;
  const Eigen::Vector2d high = middle.array() + reach;
  for (int y = static_cast<int>(low.y()); y <= high.y(); ++y) {
    for (int x = static_cast<int>(low.x()); x <= high.x(); ++x) {
      if (cell_at(x, y) == cell) {
        picture.set(x, y, colour);
      }
    }
  }
}

Picture MapView::draw() const {
  Picture picture(width_, height(), kFloorColour);
  picture.draw_text(kMargin, 8, params_.title, kTextScale, kInkColour);
  draw_cells(picture);
  draw_scale_bar(picture);
  draw_legend(picture);
  return picture;
}

std::vector<bool> MapView::grid_pixels(double low_m, int count) const {
  std::vector<bool> is_on_grid(static_cast<std::size_t>(count), false);
  if (!params_.shows_metre_grid) {
    return is_on_grid;
  }
  const double spacing_m = grid_spacing_m(frame_.size_m);
  // An edge that is on a line but for rounding begins the pixel of the line.
  const auto lines_below = [&](int edge) {
    return std::floor((low_m + edge * metres_per_pixel_) / spacing_m + 1e-6);
  };
  for (int i = 0; i < count; ++i) {
    is_on_grid[static_cast<std::size_t>(i)] = lines_below(i) > lines_below(i - 1);
  }
  return is_on_grid;
}

void MapView::draw_cells(Picture& picture) const {
  const auto column_is_on_grid = grid_pixels(frame_.low_m.x() - left_ * metres_per_pixel_, width_);
  const auto row_is_on_grid = grid_pixels(frame_.low_m.y(), map_height());
  for (int y = top_; y < map_bottom(); ++y) {
    const bool is_on_row = row_is_on_grid[static_cast<std::size_t>(map_bottom() - 1 - y)];
    for (int x = 0; x < width_; ++x) {
      const bool is_on_grid = is_on_row || column_is_on_grid[static_cast<std::size_t>(x)];
      picture.set(x, y, colour_of(map_.state(cell_at(x, y)), x, y, is_on_grid));
    }
  }
}

void MapView::draw_scale_bar(Picture& picture) const {
  const double length_m = scale_bar_m(width_ * metres_per_pixel_ / 3.0);
  const int length = static_cast<int>(std::lround(pixels(length_m)));
  const int y = map_bottom() + kFooterHeight / 2;
  picture.fill_rectangle(kMargin, y - kBarThickness / 2, length, kBarThickness, kInkColour);
  for (const int x : {kMargin, kMargin + length - 2}) {
    picture.fill_rectangle(x, y - 2 * kBarThickness, 2, 4 * kBarThickness, kInkColour);
  }
  const int text_x = 2 * kMargin + length;
  const std::string text = scale_text(length_m, grid_spacing_m(frame_.size_m));
  const bool has_room = text_x + Picture::text_width(text, kTextScale) <= width_;
  picture.draw_text(text_x,
                    y - 7,
                    params_.shows_metre_grid && has_room ? text : length_text(length_m),
                    kTextScale,
                    kInkColour);
}

void MapView::draw_legend(Picture& picture) const {
  const int columns = legend_columns();
  const int column_width = legend_width(params_.legend);
  int number = 0;
  for (const LegendEntry& entry : params_.legend) {
    const int x = kMargin + number % columns * column_width;
    const int y = map_bottom() + kFooterHeight + number / columns * kLegendLine;
    picture.fill_rectangle(x, y, kSwatch, kSwatch, kInkColour);
    picture.fill_rectangle(x + 1, y + 1, kSwatch - 2, kSwatch - 2, entry.colour);
    picture.draw_text(x + kSwatch + kMargin, y, entry.text, kTextScale, kInkColour);
    ++number;
  }
}

std::vector<PngText> MapView::texts() const {
  const Eigen::Vector2d corner_m = frame_.in_map_m(
      frame_.low_m - metres_per_pixel_ * Eigen::Vector2d(left_, height() - map_bottom()));
  return {{"Software", "echomap"},
          {"resolution", fmt::format("{:.9g}", metres_per_pixel_)},
          {"origin",
           fmt::format("[{:.9g}, {:.9g}, {:.9g}]", corner_m.x(), corner_m.y(), frame_.turn_rad)}};
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

double grid_spacing_m(const Eigen::Vector2d& size_m) {
  constexpr double kSmallM = 3.0;
  constexpr double kLargeM = 30.0;
  const double side_m = size_m.maxCoeff();
  return side_m < kSmallM ? 0.5 : side_m > kLargeM ? 5.0 : 1.0;
}

std::string scale_text(double length_m, double spacing_m) {
  return length_text(length_m) + ", grid " + length_text(spacing_m);
}

std::string length_text(double length_m) { return fmt::format("{:.9g} m", length_m); }

}  // namespace echomap::exports
