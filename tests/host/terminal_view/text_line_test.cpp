// SPDX-License-Identifier: MIT
#include "host/terminal_view/text_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::terminal_view {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Le;

TEST(ColumnsOf, CountsCharactersAndNoColours) {
  EXPECT_EQ(columns_of(""), 0);
  EXPECT_EQ(columns_of("5.2 m²"), 6);
  EXPECT_EQ(columns_of("\033[38;5;16;48;5;255m▀█\033[0m"), 2);
  EXPECT_EQ(columns_of("ab\033["), 2) << "a sequence that is cut off";
}

TEST(Printable, LeavesNothingThatMovesTheCursorOrIsWide) {
  EXPECT_EQ(printable("Küche, 5 m²", Glyphs::kHalfBlocks), "Küche, 5 m²");
  EXPECT_EQ(printable("\033[2Ja\tb\n", Glyphs::kHalfBlocks), "?[2Ja?b?");
  EXPECT_EQ(printable("地图", Glyphs::kHalfBlocks), "??");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J",
                      Glyphs::kHalfBlocks),
            "?2J")
      << "a CSI of one character";
}

TEST(Printable, SpellsSignsInAscii) {
  EXPECT_EQ(printable("5 m², 90°, ±3 cm, ü", Glyphs::kAscii), "5 m2, 90 deg, +-3 cm, ?");
}

TEST(Wrapped, BreaksAtSpacesAndCutsLongWords) {
  EXPECT_THAT(wrapped("drives to see new floor", 10), ElementsAre("drives to", "see new", "floor"));
  EXPECT_THAT(wrapped("abcdefgh", 3), ElementsAre("abc", "def", "gh"));
  EXPECT_THAT(wrapped("m²m²", 2), ElementsAre("m²", "m²"));
  EXPECT_THAT(wrapped("", 10), IsEmpty());
  EXPECT_THAT(wrapped("a", 0), IsEmpty());
}

TEST(Flowed, PutsShortFactsIntoOneLine) {
  EXPECT_THAT(flowed({"one", "two", "three"}, 10), ElementsAre("one  two", "three"));
  EXPECT_THAT(flowed({"one", "a long fact", "two"}, 8),
              ElementsAre("one", "a long", "fact", "two"));
  EXPECT_THAT(flowed({}, 8), IsEmpty());
}

TEST(Flowed, IsNeverTooWide) {
  for (int columns = 1; columns < 40; ++columns) {
    for (const std::string& line :
         flowed({"7 stops", "8.9 m² mapped", "http://127.0.0.1:8080/"}, columns)) {
      EXPECT_THAT(columns_of(line), Le(columns)) << line;
    }
  }
}

}  // namespace
}  // namespace echomap::terminal_view
