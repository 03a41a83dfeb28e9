// SPDX-License-Identifier: MIT
#include "host/terminal_view/run_view.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "host/terminal_view/text_line.hpp"

namespace echomap::terminal_view {
namespace {

using Lines = std::vector<std::string>;

/// From so many columns on, the status is beside the map.
constexpr int kWideColumns = 72;
constexpr int kStatusColumns = 32;
constexpr int kGap = 2;
constexpr int kMinMapLines = 4;
/// Below the map, of a terminal that is narrow.
constexpr int kLegendLines = 2;
constexpr int kMinLinesWithLegend = 16;
/// Of `map_legend`.
constexpr int kTrailEntry = 3;
constexpr int kParticleEntry = 4;

void keep_first(Lines& lines, int count) {
  lines.resize(std::min(lines.size(), static_cast<std::size_t>(std::max(count, 0))));
}

/// What the map's colours mean, but for marks that it does not have, and its scale.
Lines legend_of(const RunView& view, const MapDrawing& drawing, Glyphs glyphs) {
  if (drawing.lines.empty()) {
    return {};
  }
  Lines legend = map_legend(glyphs);
  if (view.marks.particles_m.empty()) {
    legend.erase(legend.begin() + kParticleEntry);
  }
  if (view.marks.trail_m.empty()) {
    legend.erase(legend.begin() + kTrailEntry);
  }
  legend.push_back(fmt::format("column: {:.3g} cm", 100.0 * drawing.column_m));
  return legend;
}

/// A fact a line; one that is too long takes more.
Lines in_lines(const Lines& facts, int columns) {
  Lines lines;
  for (const std::string& fact : facts) {
    const Lines parts = wrapped(fact, columns);
    lines.insert(lines.end(), parts.begin(), parts.end());
  }
  return lines;
}

Lines beside_the_map(const RunView& view, TextSize room, Glyphs glyphs) {
  const TextSize map_room{room.columns - kStatusColumns - kGap, room.lines};
  const MapDrawing drawing = draw_map(view.map, view.marks, map_room, glyphs);
  // The status stays where it is while a map grows to a square.
  const int map_columns = std::max(drawing.columns, std::min(map_room.columns, 2 * room.lines));
  const int left = drawing.lines.empty() ? 0 : map_columns + kGap;
  const int right = room.columns - left;
  Lines status = in_lines(status_facts(view.status, glyphs), right);
  const Lines legend = flowed(legend_of(view, drawing, glyphs), right);
  status.insert(status.end(), legend.begin(), legend.end());
  keep_first(status, room.lines);
  Lines lines;
  for (std::size_t i = 0; i < std::max(drawing.lines.size(), status.size()); ++i) {
    const bool has_map = i < drawing.lines.size();
    std::string line =
        has_map ? drawing.lines[i] : std::string(static_cast<std::size_t>(drawing.columns), ' ');
    if (i < status.size()) {
      line += std::string(static_cast<std::size_t>(left - drawing.columns), ' ') + status[i];
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Lines below_the_map(const RunView& view, TextSize room, Glyphs glyphs) {
  Lines status = flowed(status_facts(view.status, glyphs), room.columns);
  keep_first(status, room.lines);
  TextSize map_room = room;
  map_room.lines -=
      static_cast<int>(status.size()) + (room.lines < kMinLinesWithLegend ? 0 : kLegendLines);
  const MapDrawing drawing = map_room.lines < kMinMapLines
                                 ? MapDrawing()
                                 : draw_map(view.map, view.marks, map_room, glyphs);
  Lines lines = drawing.lines;
  lines.insert(lines.end(), status.begin(), status.end());
  const Lines legend = flowed(legend_of(view, drawing, glyphs), room.columns);
  lines.insert(lines.end(), legend.begin(), legend.end());
  keep_first(lines, room.lines);
  return lines;
}

}  // namespace

std::vector<std::string> lines_of(const RunView& view, TextSize room, Glyphs glyphs) {
  return room.columns >= kWideColumns ? beside_the_map(view, room, glyphs)
                                      : below_the_map(view, room, glyphs);
}

}  // namespace echomap::terminal_view
