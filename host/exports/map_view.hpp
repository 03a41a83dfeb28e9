// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exports/picture.hpp"
#include "host/exports/picture_frame.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

/// Okabe and Ito's palette on greys, told apart with any colour vision.
constexpr Colour kFloorColour{255, 255, 255};
constexpr Colour kUnknownColour{208, 211, 217};
constexpr Colour kWallColour{40, 40, 40};
/// Of the metre grid: darker than floor and lighter than unknown ground, so that it is read on both
/// and in front of nothing.
constexpr Colour kGridColour{226, 229, 236};
constexpr Colour kInkColour{20, 20, 20};
constexpr Colour kOrange{230, 159, 0};
constexpr Colour kSkyBlue{86, 180, 233};
constexpr Colour kGreen{0, 158, 115};
constexpr Colour kBlue{0, 114, 178};
constexpr Colour kVermilion{213, 94, 0};
constexpr Colour kPurple{204, 121, 167};

/// What a colour in a picture means.
struct LegendEntry {
  Colour colour;
  std::string text;  ///< In the letters of picture_font.hpp.
};

/// What a picture of a map shows beside its cells.
struct MapViewParams {
  std::vector<LegendEntry> legend{};
  std::string title{};  ///< Above the map; empty: none. In the letters of picture_font.hpp.
  /// How far the picture is turned in the map frame, counter-clockwise.
  double turn_rad = 0.0;
  /// Points of the map frame that the picture must hold, the trajectory for one.
  std::vector<Eigen::Vector2d> points_m{};
  /// The part of the map frame that the picture shows, so that pictures of several maps show the
  /// same; empty: the map and `points_m`, turned by `turn_rad`.
  std::optional<PictureFrame> frame{};
  /// Whether floor and unknown ground have the lines of the metre grid, and the scale bar its
  /// spacing. Not where every cell gets a colour of its own.
  bool shows_metre_grid = true;
  /// The map is drawn no wider than this, in pixels; empty: only the largest size of a picture
  /// limits it.
  std::optional<int> max_map_width_px{};
};

/// A picture of a map for people: its cells enlarged, with a title above, a scale bar and a legend
/// below.
class MapView {
 public:
  explicit MapView(const mapping::RasterMap& map, MapViewParams params = {});

  /// The cells, the scale bar and the legend: what all else is drawn onto.
  Picture draw() const;

  double pixels(double length_m) const { return length_m / metres_per_pixel_; }
  /// Of a point of the map frame.
  Eigen::Vector2d place(const Eigen::Vector2d& point_m) const;
  /// Whether a place is on the map, and not on the title or the footer.
  bool is_on_map(const Eigen::Vector2d& place) const {
    return place.y() >= top_ && place.y() < map_bottom();
  }
  /// Leaves the title and the footer of a picture as they are, whatever is drawn onto it.
  void limit_to_map(Picture& picture) const { picture.limit_rows(top_, map_bottom()); }
  /// Paints one cell of the map.
  void fill_cell(Picture& picture, geometry::CellIndex cell, Colour colour) const;

  /// How many letters of a title a picture of that width has room for.
  static std::size_t title_letters(int width_px);

  /// tEXt chunks that place the picture: `resolution` in metres per pixel and `origin`, the pose of
  /// its lower left corner, footer included, in the map frame: x, y and how far the picture is
  /// turned, as map.yaml has them.
  std::vector<PngText> texts() const;

 private:
  int map_height() const;
  int map_bottom() const { return top_ + map_height(); }
  int legend_columns() const;
  int height() const;
  /// The cell of the map that the middle of a pixel shows.
  geometry::CellIndex cell_at(int x, int y) const;
  /// Of a row of pixels that begins there in the picture's axes, those on a line of the grid.
  std::vector<bool> grid_pixels(double low_m, int count) const;
  void draw_cells(Picture& picture) const;
  void draw_scale_bar(Picture& picture) const;
  void draw_legend(Picture& picture) const;

  mapping::RasterMap map_;
  MapViewParams params_;
  PictureFrame frame_;
  double metres_per_pixel_;
  int width_;
  int left_;
  int top_;
};

/// The largest round length (1, 2 or 5 times a power of ten, 10 m at most) that is no longer than
/// `longest_m`; 0.1 m where none is.
double scale_bar_m(double longest_m);

/// The spacing of the metre grid on a map of that size: 1 m, for what is smaller than 3 m 0.5 m and
/// for what is larger than 30 m 5 m. Its lines are along the picture's axes, through the origin of
/// the map frame, where the robot has started.
double grid_spacing_m(const Eigen::Vector2d& size_m);

/// What a scale bar says: its length and the spacing of the grid, as "1 m, grid 0.5 m".
std::string scale_text(double length_m, double spacing_m);

/// Shortest decimals of a length, as "0.5 m".
std::string length_text(double length_m);

}  // namespace echomap::exports
