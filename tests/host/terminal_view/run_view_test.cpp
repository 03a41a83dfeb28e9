// SPDX-License-Identifier: MIT
#include "host/terminal_view/run_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/terminal_view/text_line.hpp"
#include "tests/host/terminal_view/drawn_room.hpp"

namespace echomap::terminal_view {
namespace {

using ::testing::ElementsAre;

RunView shown_run() {
  RunView view{drawn_room({"##########",
                           "#........#",
                           "#........#",
                           "#........#",
                           "#........#",
                           "#........#",
                           "#........#",
                           "##########"}),
               {},
               {}};
  view.marks.T_map_robot = geometry::Pose2(0.25, 0.35, 0.0);
  view.marks.trail_m = {{0.15, 0.35}, {0.25, 0.35}};
  view.status.mode = "exploring by frontier";
  view.status.doing = "drives 0.80 m";
  view.status.T_map_robot = view.marks.T_map_robot;
  view.status.position_95_m = 0.05;
  view.status.stops = 3;
  view.status.floor_m2 = 0.48;
  view.status.elapsed_s = 65.0;
  return view;
}

TEST(LinesOf, PutTheStatusBelowTheMapOfANarrowTerminal) {
  EXPECT_THAT(lines_of(shown_run(), {40, 18}, Glyphs::kAscii),
              ElementsAre("##########",
                          "#........#",
                          "#+>......#",
                          "##########",
                          "exploring by frontier  drives 0.80 m",
                          "at 0.25, 0.35 m, 0 deg, +-5 cm (95 %)",
                          "3 stops, 0.5 m2 mapped  1:05 elapsed",
                          "'#' wall  '.' floor  ' ' unknown",
                          "'+' path  column: 10 cm"));
}

TEST(LinesOf, PutTheStatusBesideTheMapOfAWideTerminal) {
  EXPECT_THAT(
      lines_of(shown_run(), {79, 6}, Glyphs::kAscii),
      ElementsAre("##########    exploring by frontier",
                  "#........#    drives 0.80 m",
                  "#+>......#    at 0.25, 0.35 m, 0 deg, +-5 cm (95 %)",
                  "##########    3 stops, 0.5 m2 mapped",
                  "              1:05 elapsed",
                  "              '#' wall  '.' floor  ' ' unknown  '+' path  column: 10 cm"));
}

TEST(LinesOf, LeaveTheMapOutOfATerminalWithoutRoomForIt) {
  EXPECT_THAT(lines_of(shown_run(), {40, 4}, Glyphs::kAscii),
              ElementsAre("exploring by frontier  drives 0.80 m",
                          "at 0.25, 0.35 m, 0 deg, +-5 cm (95 %)",
                          "3 stops, 0.5 m2 mapped  1:05 elapsed"));
}

TEST(LinesOf, AreWithinEveryTerminal) {
  RunView view = shown_run();
  view.status.why = "it has not seen what is behind the table in the corner";
  view.status.page_url = "http://192.168.100.100:54321/?token=0123456789abcdef0123456789abcdef";
  view.status.link = LinkHealth{123.4, 1000000, 1000000, 1000};
  view.marks.particles_m = {{0.5, 0.5}};
  for (int columns = 1; columns < 130; ++columns) {
    for (int lines = 1; lines < 40; ++lines) {
      for (const Glyphs glyphs : {Glyphs::kAscii, Glyphs::kHalfBlocks}) {
        const auto drawn = lines_of(view, {columns, lines}, glyphs);
        ASSERT_LE(drawn.size(), static_cast<std::size_t>(lines)) << columns;
        for (const std::string& line : drawn) {
          ASSERT_LE(columns_of(line), columns) << line;
        }
      }
    }
  }
}

}  // namespace
}  // namespace echomap::terminal_view
