// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "tests/benchmarks/edge_counts.hpp"

namespace echomap::bench {
namespace {

using ::testing::ElementsAre;

/// The cells of the row with that title.
std::vector<std::string> row_named(const MarkdownTable& table, const std::string& title) {
  const auto found = std::find_if(
      table.rows.begin(), table.rows.end(), [&](const auto& row) { return row.front() == title; });
  return found == table.rows.end() ? std::vector<std::string>{}
                                   : std::vector<std::string>(found->begin() + 1, found->end());
}

BoardColumn uno_with(const std::vector<EdgeCount>& counts) {
  BoardColumn column{"uno", "simavr 1.6", true, figures_of(counts)};
  column.figures.push_back({"flash_bytes_uno", 22344, "B", 1, {}});
  column.figures.push_back({"hang_off_ms", 127.31, "ms", 1, {}});
  return column;
}

BoardColumn ev3() {
  return {"ev3", "qemu-arm 7.2", false, {{"ev3_crash_off_ms", 131.2, "ms", 3, {}}}};
}

TEST(BoardTable, HasAColumnForEachBoardWithItsEmulator) {
  const MarkdownTable table = board_table({uno_with({}), ev3()});
  EXPECT_THAT(table.header, ElementsAre("", "uno", "ev3"));
  EXPECT_THAT(row_named(table, "emulator"), ElementsAre("simavr 1.6", "qemu-arm 7.2"));
  EXPECT_THAT(row_named(table, "flash, B"), ElementsAre("22344", "-"));
  EXPECT_THAT(row_named(table, "hang to off, ms"), ElementsAre("127.3", "-"));
  EXPECT_THAT(row_named(table, "crash to off, ms"), ElementsAre("-", "131.2"));
}

TEST(BoardTable, SaysWhatBecameOfTheCounts) {
  const MarkdownTable table = board_table({uno_with({{40, 0, 10, 0, 0, 0},
                                                     {80, 0, 10, 17, 12, 0},
                                                     {80, 20, 0, 0, 0, 0},
                                                     {200, 0, 10, 32386, 21932, 0},
                                                     {200, 40, 10, 900, 0, 1}}),
                                           ev3()});
  EXPECT_THAT(row_named(table, "miscounts at 40k edges/s, 0 % jitter"),
              ElementsAre("0", "counted by the motors"));
  EXPECT_EQ(row_named(table, "miscounts at 80k edges/s, 0 % jitter").front(),
            "17, 12 steps reported lost");
  EXPECT_EQ(row_named(table, "miscounts at 80k edges/s, 20 % jitter").front(), "no report");
  EXPECT_EQ(row_named(table, "miscounts at 200k edges/s, 0 % jitter").front(), "over 10000");
  EXPECT_EQ(row_named(table, "miscounts at 200k edges/s, 40 % jitter").front(), "resets");
}

TEST(BoardTable, SaysThatMotorsNeverGoOffAndThatNothingWasMeasured) {
  const BoardColumn hung{"mega", "simavr 1.6", true, {{"hang_off_ms", INFINITY, "ms", 1, {}}}};
  const BoardColumn missing{"ev3", "not measured: echomap-ev3.elf is not built", false, {}};
  const MarkdownTable table = board_table({hung, missing});
  EXPECT_THAT(row_named(table, "hang to off, ms"), ElementsAre("never", "-"));
  EXPECT_THAT(row_named(table, "miscounts at 40k edges/s, 0 % jitter"), ElementsAre("-", "-"));
}

TEST(BoardReport, IsReadFromTheJsonOfTheProgramThatMeasures) {
  const BoardReport report = read_board_report(
      R"({"notes": {"uno": "simavr 1.6"}, "figures": [
          {"name": "hang_off_ms", "value": null, "unit": "ms", "runs": 1, "peers": {}},
          {"name": "flash_bytes_uno", "value": 22344.0, "unit": "B", "runs": 1, "peers": {}}]})",
      "uno");
  EXPECT_EQ(report.emulator, "simavr 1.6");
  ASSERT_EQ(report.figures.size(), 2U);
  EXPECT_TRUE(std::isinf(report.figures[0].value));
  EXPECT_DOUBLE_EQ(report.figures[1].value, 22344.0);
}

TEST(FiguresByBoard, HaveTheBoardInTheirNamesOnce) {
  const auto figures = figures_by_board({uno_with({}), ev3()});
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[0].name, "flash_bytes_uno");
  EXPECT_EQ(figures[1].name, "uno_hang_off_ms");
  EXPECT_EQ(figures[2].name, "ev3_crash_off_ms");
}

}  // namespace
}  // namespace echomap::bench
