// SPDX-License-Identifier: MIT
#include "host/terminal_view/half_block_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace echomap::terminal_view {
namespace {

using geometry::CellIndex;
using mapping::CellBounds;
using mapping::CellState;

/// What a pixel shows; of what is within it, the last.
enum class Pixel : std::uint8_t { kUnknown, kFree, kTrail, kParticle, kOccupied };

/// Colours of the 256 that terminals share, by Pixel: those of map.png, with a darker unknown.
constexpr std::array<int, 5> kPixelColours{246, 255, 31, 214, 16};
constexpr int kRobotColour = 166;
constexpr std::array<char, 5> kPixelLetters{' ', '.', '+', ':', '#'};
constexpr std::array<std::string_view, 8> kArrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};
constexpr std::array<std::string_view, 4> kAsciiArrows{">", "^", "<", "v"};

/// Pixels are so many parts of a cell wide, or more: the scale changes in small steps.
constexpr int kPartsOfCell = 4;

std::int32_t floor_divided(std::int64_t dividend, std::int64_t divisor) {
  return static_cast<std::int32_t>(dividend / divisor - (dividend % divisor < 0 ? 1 : 0));
}

Pixel pixel_of(CellState state) {
  switch (state) {
    case CellState::kOccupied:
      return Pixel::kOccupied;
    case CellState::kFree:
      return Pixel::kFree;
    case CellState::kUnknown:
      break;
  }
  return Pixel::kUnknown;
}

/// The smallest rectangle around all known cells; the whole map where there is none.
CellBounds known_part(const mapping::RasterMap& map) {
  CellBounds known;
  for (int y = 0; y < map.rows(); ++y) {
    const CellState* row = map.row(y);
    for (int x = 0; x < map.columns(); ++x) {
      if (row[x] != CellState::kUnknown) {
        known = mapping::united(known, {{x, y}, {x, y}});
      }
    }
  }
  return known.empty() ? CellBounds{{0, 0}, {map.columns() - 1, map.rows() - 1}} : known;
}

/// Which pixel a cell is in. Every cell is in one, every pixel has a cell.
class PixelScale {
 public:
  PixelScale(const mapping::RasterMap& map, int parts)
      : parts_(parts),
        offset_{static_cast<std::int32_t>(std::lround(map.origin_m().x() / map.resolution_m())),
                static_cast<std::int32_t>(std::lround(map.origin_m().y() / map.resolution_m()))} {}

  CellIndex pixel(CellIndex cell) const {
    return {part_of(std::int64_t{cell.x} + offset_.x), part_of(std::int64_t{cell.y} + offset_.y)};
  }
  /// A line shows an even pixel below an odd one.
  static int line(int pixel_y) { return floor_divided(pixel_y, 2); }
  TextSize size(const CellBounds& cells) const {
    const CellIndex low = pixel(cells.min);
    const CellIndex high = pixel(cells.max);
    return {high.x - low.x + 1, line(high.y) - line(low.y) + 1};
  }
  double cells_per_pixel() const { return static_cast<double>(parts_) / kPartsOfCell; }

 private:
  /// Of a cell counted from the map frame's origin: the pixel that its middle is in.
  int part_of(std::int64_t cell) const {
    return floor_divided(kPartsOfCell * cell + kPartsOfCell / 2, parts_);
  }

  int parts_;
  CellIndex offset_;
};

/// The largest scale at which the cells fit.
PixelScale fitting_scale(const mapping::RasterMap& map, const CellBounds& cells, TextSize room) {
  int parts = kPartsOfCell;
  const auto fits = [&] {
    const TextSize size = PixelScale(map, parts).size(cells);
    return size.columns <= room.columns && size.lines <= room.lines;
  };
  while (!fits() && parts < kPartsOfCell * 2 * std::max(cells.columns(), cells.rows())) {
    ++parts;
  }
  return {map, parts};
}

/// The pixels of whole lines around some cells.
class PixelField {
 public:
  PixelField(const PixelScale& scale, const CellBounds& cells)
      : scale_(scale),
        left_(scale.pixel(cells.min).x),
        top_line_(PixelScale::line(scale.pixel(cells.max).y)),
        size_(scale.size(cells)),
        pixels_(static_cast<std::size_t>(size_.columns) * 2U *
                static_cast<std::size_t>(size_.lines)) {}

  TextSize size() const { return size_; }
  /// From the left and the top.
  CellIndex place(CellIndex cell) const {
    const CellIndex pixel = scale_.pixel(cell);
    return {pixel.x - left_, 2 * top_line_ + 1 - pixel.y};
  }
  bool holds(CellIndex place) const {
    return place.x >= 0 && place.x < size_.columns && place.y >= 0 && place.y < 2 * size_.lines;
  }
  Pixel at(CellIndex place) const { return pixels_[index_of(place)]; }
  void add(CellIndex place, Pixel pixel) {
    if (holds(place)) {
      Pixel& shown = pixels_[index_of(place)];
      shown = std::max(shown, pixel);
    }
  }

 private:
  std::size_t index_of(CellIndex place) const {
    return static_cast<std::size_t>(place.y) * static_cast<std::size_t>(size_.columns) +
           static_cast<std::size_t>(place.x);
  }

  PixelScale scale_;
  int left_;
  int top_line_;
  TextSize size_;
  std::vector<Pixel> pixels_;
};

void add_cells(const mapping::RasterMap& map, const CellBounds& cells, PixelField& field) {
  for (int y = cells.min.y; y <= cells.max.y; ++y) {
    const CellState* row = map.row(y);
    for (int x = cells.min.x; x <= cells.max.x; ++x) {
      field.add(field.place({x, y}), pixel_of(row[x]));
    }
  }
}

void add_marks(const mapping::RasterMap& map, const MapMarks& marks, PixelField& field) {
  for (const Eigen::Vector2d& point : marks.trail_m) {
    field.add(field.place(map.cell_at(point)), Pixel::kTrail);
  }
  for (const Eigen::Vector2d& point : marks.particles_m) {
    field.add(field.place(map.cell_at(point)), Pixel::kParticle);
  }
}

template <std::size_t kDirections>
std::string_view arrow(const std::array<std::string_view, kDirections>& arrows,
                       double heading_rad) {
  const double turns = heading_rad / (2.0 * std::numbers::pi);
  const auto direction = std::lround((turns - std::floor(turns)) * kDirections);
  return arrows[static_cast<std::size_t>(direction) % kDirections];
}

std::string ascii_line(const PixelField& field, int line) {
  std::string text;
  for (int x = 0; x < field.size().columns; ++x) {
    const Pixel shown = std::max(field.at({x, 2 * line}), field.at({x, 2 * line + 1}));
    text += kPixelLetters[static_cast<std::size_t>(shown)];
  }
  return text;
}

int colour_of(Pixel pixel) { return kPixelColours[static_cast<std::size_t>(pixel)]; }

/// Two pixels, one above the other, as a character in two colours.
struct ColouredCharacter {
  std::string_view character;
  int foreground;
  int background;
};

/// What is occupied is ink.
ColouredCharacter character_of(Pixel upper, Pixel lower) {
  if (upper == lower) {
    return upper == Pixel::kOccupied
               ? ColouredCharacter{"█", colour_of(upper), colour_of(Pixel::kFree)}
               : ColouredCharacter{" ", colour_of(Pixel::kOccupied), colour_of(upper)};
  }
  return lower > upper ? ColouredCharacter{"▄", colour_of(lower), colour_of(upper)}
                       : ColouredCharacter{"▀", colour_of(upper), colour_of(lower)};
}

/// A line of coloured characters, with a colour sequence where colours change.
std::string coloured_line(const std::vector<ColouredCharacter>& characters) {
  std::string text;
  int foreground = -1;
  int background = -1;
  for (const ColouredCharacter& next : characters) {
    if (next.foreground != foreground || next.background != background) {
      foreground = next.foreground;
      background = next.background;
      text += fmt::format("\033[38;5;{};48;5;{}m", foreground, background);
    }
    text += next.character;
  }
  return text + "\033[0m";
}

std::vector<ColouredCharacter> half_blocks(const PixelField& field, int line) {
  std::vector<ColouredCharacter> characters;
  for (int x = 0; x < field.size().columns; ++x) {
    characters.push_back(character_of(field.at({x, 2 * line}), field.at({x, 2 * line + 1})));
  }
  return characters;
}

/// One line of the field; where the robot is in it, `robot` says in which column it points where.
std::string drawn_line(const PixelField& field,
                       int line,
                       const std::optional<CellIndex>& robot,
                       double heading_rad,
                       Glyphs glyphs) {
  const bool has_robot = robot && robot->y / 2 == line;
  if (glyphs == Glyphs::kAscii) {
    std::string text = ascii_line(field, line);
    if (has_robot) {
      text.replace(static_cast<std::size_t>(robot->x), 1, arrow(kAsciiArrows, heading_rad));
    }
    return text;
  }
  std::vector<ColouredCharacter> characters = half_blocks(field, line);
  if (has_robot) {
    const int ground =
        colour_of(field.at(*robot) == Pixel::kUnknown ? Pixel::kUnknown : Pixel::kFree);
    characters[static_cast<std::size_t>(robot->x)] = {
        arrow(kArrows, heading_rad), kRobotColour, ground};
  }
  return coloured_line(characters);
}

}  // namespace

MapDrawing draw_map(const mapping::RasterMap& map,
                    const MapMarks& marks,
                    TextSize room,
                    Glyphs glyphs) {
  if (room.columns < 2 || room.lines < 2) {
    return {};
  }
  const CellBounds cells = known_part(map);
  const PixelScale scale = fitting_scale(map, cells, room);
  PixelField field(scale, cells);
  add_cells(map, cells, field);
  add_marks(map, marks, field);
  std::optional<CellIndex> robot;
  if (marks.T_map_robot) {
    const CellIndex place = field.place(map.cell_at(marks.T_map_robot->position_m()));
    robot = field.holds(place) ? std::optional(place) : std::nullopt;
  }
  const double heading_rad = marks.T_map_robot ? marks.T_map_robot->heading_rad() : 0.0;
  MapDrawing drawing{{}, field.size().columns, scale.cells_per_pixel() * map.resolution_m()};
  for (int line = 0; line < field.size().lines; ++line) {
    drawing.lines.push_back(drawn_line(field, line, robot, heading_rad, glyphs));
  }
  return drawing;
}

std::vector<std::string> map_legend(Glyphs glyphs) {
  static constexpr std::array<std::pair<Pixel, std::string_view>, 5> kMeanings{
      {{Pixel::kOccupied, "wall"},
       {Pixel::kFree, "floor"},
       {Pixel::kUnknown, "unknown"},
       {Pixel::kTrail, "path"},
       {Pixel::kParticle, "may be here"}}};
  std::vector<std::string> legend;
  for (const auto& [pixel, meaning] : kMeanings) {
    const char letter = kPixelLetters[static_cast<std::size_t>(pixel)];
    legend.push_back(glyphs == Glyphs::kAscii
                         ? fmt::format("'{}' {}", letter, meaning)
                         : fmt::format("\033[48;5;{}m  \033[0m {}", colour_of(pixel), meaning));
  }
  return legend;
}

}  // namespace echomap::terminal_view
