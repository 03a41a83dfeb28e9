// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exports/map_view.hpp"
#include "host/exports/picture_frame.hpp"

namespace echomap::exports {

/// The sheet of paper around a map: a title above, a scale bar and the legend below. One unit is a
/// millimetre, x right and y down. The map has the largest round scale at which it fits on a page
/// of A4.
class SvgSheet {
 public:
  SvgSheet(const PictureFrame& frame, std::string title, std::vector<LegendEntry> legend);

  /// How many metres of the room a metre on paper is.
  double scale() const { return scale_; }
  /// A width on paper as one in the room.
  double metres(double millimetres) const { return millimetres * scale_ / 1000.0; }

  /// Up to and with the opening of the map's group, which is in metres of the map frame and shows
  /// nothing outside of the map's place on the sheet.
  std::string header() const;
  /// The path `grid`, the lines of the metre grid: an element of the map's group, to lie on its
  /// floor and below all else.
  std::string grid() const;
  /// From the end of that group on.
  std::string footer() const;

 private:
  double bar_m() const;
  std::string bar_text() const;
  double scale_width_mm() const;  ///< Of the bar and its text.
  Eigen::Vector2d legend_place(std::size_t entry) const;

  PictureFrame frame_;
  std::string title_;
  std::vector<LegendEntry> legend_;
  double scale_;
  double column_mm_ = 0.0;  ///< Width of an entry of the legend.
  std::size_t columns_ = 1;
  Eigen::Vector2d map_corner_mm_;  ///< Upper left.
  Eigen::Vector2d map_size_mm_;
  Eigen::Vector2d size_mm_;
};

}  // namespace echomap::exports
