// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_comparison.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

BoardRuns runs_with(const std::string& board, double free_iou, bool passes = true) {
  return {board, "", {{"free_iou", free_iou, "", 20, {}}}, passes};
}

TEST(BoardComparison, CountsBoardsWithinAHundredthOfEachOther) {
  const auto figures = compare_boards(
      {runs_with("uno", 0.950), runs_with("mega", 0.955), runs_with("stm32f103", 0.960)});
  EXPECT_DOUBLE_EQ(value_of(figures, "boards_passing"), 3.0);
  EXPECT_NEAR(value_of(figures, "free_iou_spread"), 0.010, 1e-12);
  EXPECT_DOUBLE_EQ(value_of(figures, "mega_free_iou"), 0.955);
}

TEST(BoardComparison, LeavesOutABoardThatIsFurtherFromTheOthers) {
  const auto figures = compare_boards(
      {runs_with("uno", 0.930), runs_with("mega", 0.955), runs_with("stm32f103", 0.960)});
  EXPECT_DOUBLE_EQ(value_of(figures, "boards_passing"), 2.0);
  EXPECT_NEAR(value_of(figures, "free_iou_spread"), 0.030, 1e-12);
}

TEST(BoardComparison, CountsNoBoardThatFailsItsOwnBounds) {
  const auto figures = compare_boards({runs_with("uno", 0.95), runs_with("mega", 0.95, false)});
  EXPECT_DOUBLE_EQ(value_of(figures, "boards_passing"), 1.0);
}

TEST(BoardComparison, CountsNoBoardThatIsNotBuilt) {
  const BoardRuns pico{"pico", "echomap-pico.elf", {}, false};
  const auto figures = compare_boards({runs_with("uno", 0.95), pico});
  EXPECT_DOUBLE_EQ(value_of(figures, "boards_passing"), 1.0);
  EXPECT_EQ(figures.back().runs, 2U);
  EXPECT_THROW(value_of(figures, "pico_free_iou"), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench
