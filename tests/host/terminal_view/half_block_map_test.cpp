// SPDX-License-Identifier: MIT
#include "host/terminal_view/half_block_map.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/terminal_view/text_line.hpp"
#include "tests/host/terminal_view/drawn_room.hpp"

namespace echomap::terminal_view {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

mapping::RasterMap small_room() {
  return drawn_room({"######  ", "#....#  ", "#....   ", "#....#  ", "#....#  ", "######  "});
}

MapMarks robot_at(double x_m, double y_m, double heading_rad) {
  MapMarks marks;
  marks.T_map_robot = geometry::Pose2(x_m, y_m, heading_rad);
  return marks;
}

TEST(DrawMap, DrawsACellAPixelInAscii) {
  const MapDrawing drawing = draw_map(small_room(), {}, {40, 20}, Glyphs::kAscii);
  EXPECT_THAT(drawing.lines, ElementsAre("######", "#....#", "######"))
      << "two cells are one above the other in a line; an occupied one is seen";
  EXPECT_EQ(drawing.columns, 6);
  EXPECT_DOUBLE_EQ(drawing.column_m, 0.1);
}

TEST(DrawMap, TellsUnknownFromFree) {
  const auto map = drawn_room({". . .#", ". . .#"});
  EXPECT_THAT(draw_map(map, {}, {40, 20}, Glyphs::kAscii).lines, ElementsAre(". . .#"));
  EXPECT_THAT(draw_map(map, {}, {40, 20}, Glyphs::kHalfBlocks).lines,
              ElementsAre("\033[38;5;16;48;5;255m \033[38;5;16;48;5;246m "
                          "\033[38;5;16;48;5;255m \033[38;5;16;48;5;246m "
                          "\033[38;5;16;48;5;255m █\033[0m"));
}

TEST(DrawMap, PutsTwoCellsIntoAHalfBlock) {
  EXPECT_THAT(draw_map(drawn_room({"#.#.", ".##."}), {}, {40, 20}, Glyphs::kHalfBlocks).lines,
              ElementsAre("\033[38;5;16;48;5;255m▀▄█ \033[0m"));
  EXPECT_THAT(draw_map(drawn_room({". ", " ."}), {}, {40, 20}, Glyphs::kHalfBlocks).lines,
              ElementsAre("\033[38;5;255;48;5;246m▀▄\033[0m"));
}

TEST(DrawMap, DrawsTheRobotByItsHeading) {
  const auto map = drawn_room({"...", "..."});
  const auto line = [&](double heading_rad, Glyphs glyphs) {
    return draw_map(map, robot_at(0.15, 0.05, heading_rad), {40, 20}, glyphs).lines.front();
  };
  constexpr double kPi = std::numbers::pi;
  EXPECT_EQ(line(0.0, Glyphs::kAscii), ".>.");
  EXPECT_EQ(line(0.5 * kPi, Glyphs::kAscii), ".^.");
  EXPECT_EQ(line(kPi, Glyphs::kAscii), ".<.");
  EXPECT_EQ(line(-0.5 * kPi, Glyphs::kAscii), ".v.");
  EXPECT_THAT(line(-0.01, Glyphs::kHalfBlocks), HasSubstr("\033[38;5;166;48;5;255m→"));
  EXPECT_THAT(line(0.25 * kPi, Glyphs::kHalfBlocks), HasSubstr("↗"));
  EXPECT_THAT(line(-0.75 * kPi, Glyphs::kHalfBlocks), HasSubstr("↙"));
}

TEST(DrawMap, DrawsTrailAndParticlesOnFloorAndNotOnWalls) {
  MapMarks marks;
  marks.trail_m = {{0.05, 0.05}, {0.15, 0.05}, {0.35, 0.05}};
  marks.particles_m = {{0.25, 0.05}, {0.35, 0.05}};
  EXPECT_THAT(draw_map(drawn_room({"....", "...#"}), marks, {40, 20}, Glyphs::kAscii).lines,
              ElementsAre("++:#"));
}

TEST(DrawMap, LeavesOutWhatIsOutsideHoweverFar) {
  MapMarks marks = robot_at(1e30, -1e30, 0.0);
  marks.trail_m = {{-5.0, 0.0}, {1e30, 1e30}};
  EXPECT_THAT(draw_map(drawn_room({"..", ".."}), marks, {40, 20}, Glyphs::kAscii).lines,
              ElementsAre(".."));
}

TEST(DrawMap, HasNoLinesWithoutRoom) {
  EXPECT_THAT(draw_map(small_room(), {}, {1, 20}, Glyphs::kAscii).lines, IsEmpty());
  EXPECT_THAT(draw_map(small_room(), {}, {20, 1}, Glyphs::kAscii).lines, IsEmpty());
}

TEST(DrawMap, DrawsAMapOfWhichNothingIsKnown) {
  EXPECT_THAT(
      draw_map(drawn_room({" "}), robot_at(0.05, 0.05, 0.0), {40, 20}, Glyphs::kAscii).lines,
      ElementsAre(">"));
}

TEST(DrawMap, IsNeverLargerThanItsRoom) {
  for (const Eigen::Vector2d& origin_m :
       {Eigen::Vector2d(-1.0, -0.7), Eigen::Vector2d(3.02, 0.0)}) {
    mapping::RasterMap map(53, 31, 0.05, origin_m);
    map.set({0, 0}, mapping::CellState::kOccupied);
    map.set({52, 30}, mapping::CellState::kFree);
    for (int columns = 0; columns < 70; ++columns) {
      for (int lines = 0; lines < 30; ++lines) {
        for (const Glyphs glyphs : {Glyphs::kAscii, Glyphs::kHalfBlocks}) {
          const MapDrawing drawing = draw_map(map, {}, {columns, lines}, glyphs);
          ASSERT_LE(drawing.lines.size(), static_cast<std::size_t>(lines));
          ASSERT_LE(drawing.columns, columns);
          for (const std::string& line : drawing.lines) {
            ASSERT_EQ(columns_of(line), drawing.columns) << columns << " x " << lines;
          }
        }
      }
    }
  }
}

TEST(DrawMap, WallsOfOneCellSurviveEveryScale) {
  const int size = 97;
  mapping::RasterMap map(size, size, 0.05, {-1.3, -2.2});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      map.set({x, y}, x == 40 ? mapping::CellState::kOccupied : mapping::CellState::kFree);
    }
  }
  for (int columns = 2; columns < size; ++columns) {
    const MapDrawing drawing = draw_map(map, {}, {columns, size}, Glyphs::kAscii);
    for (const std::string& line : drawing.lines) {
      ASSERT_EQ(std::count(line.begin(), line.end(), '#'), 1) << columns << ": " << line;
      ASSERT_EQ(std::count(line.begin(), line.end(), ' '), 0) << columns << ": " << line;
    }
  }
}

TEST(DrawMap, LoneCellsSurviveEveryScale) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> cell(0, 59);
  for (int trial = 0; trial < 200; ++trial) {
    mapping::RasterMap map(60, 60, 0.05, {-1.5, -1.5});
    map.set({0, 0}, mapping::CellState::kFree);
    map.set({59, 59}, mapping::CellState::kFree);
    map.set({cell(random), cell(random)}, mapping::CellState::kOccupied);
    const MapDrawing drawing = draw_map(map, {}, {2 + trial % 60, 2 + trial % 31}, Glyphs::kAscii);
    const auto holds_wall = [](const std::string& line) {
      return line.find('#') != std::string::npos;
    };
    EXPECT_EQ(std::count_if(drawing.lines.begin(), drawing.lines.end(), holds_wall), 1);
  }
}

TEST(DrawMap, ShowsTheSameGroundInAPixelWhileTheMapGrows) {
  const auto small = drawn_room({"#..", "..#"});
  mapping::RasterMap grown(5, 4, 0.1, {-0.2, -0.2});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      grown.set({x + 2, y + 2}, small.state({x, y}));
    }
  }
  grown.set({0, 0}, mapping::CellState::kFree);
  EXPECT_THAT(draw_map(small, {}, {5, 4}, Glyphs::kAscii).lines, ElementsAre("#.#"));
  EXPECT_THAT(draw_map(grown, {}, {5, 4}, Glyphs::kAscii).lines, ElementsAre("  #.#", ".    "));
}

TEST(MapLegend, NamesEveryPixel) {
  EXPECT_THAT(map_legend(Glyphs::kAscii),
              ElementsAre("'#' wall", "'.' floor", "' ' unknown", "'+' path", "':' may be here"));
  EXPECT_EQ(columns_of(map_legend(Glyphs::kHalfBlocks).front()), 7);
}

}  // namespace
}  // namespace echomap::terminal_view
