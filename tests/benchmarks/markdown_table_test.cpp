// SPDX-License-Identifier: MIT
#include "tests/benchmarks/markdown_table.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TEST(MarkdownTable, HasARuleBelowItsHeader) {
  EXPECT_EQ(to_markdown({{"room", "time"}, {{"office", "3 s"}, {"hall", ""}}}),
            "| room | time |\n|---|---|\n| office | 3 s |\n| hall |  |\n");
}

TEST(MarkdownTable, EscapesWhatWouldEndACell) {
  EXPECT_EQ(to_markdown({{"a"}, {{"x|y"}}}), "| a |\n|---|\n| x\\|y |\n");
}

TEST(MarkdownTable, RefusesARowOfAnotherLength) {
  EXPECT_THROW(to_markdown({{"a", "b"}, {{"x"}}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench
