// SPDX-License-Identifier: MIT
#include "host/exports/picture_font.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace echomap::exports {
namespace {

constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuvwxyz.,-:%/";

TEST(PictureFont, HasEveryLetterInItsSize) {
  for (const char letter : kLetters) {
    const Glyph* glyph = glyph_of(letter);
    ASSERT_NE(glyph, nullptr) << letter;
    for (const auto& row : *glyph) {
      EXPECT_EQ(row.size(), static_cast<std::size_t>(kGlyphWidth)) << letter;
      EXPECT_EQ(row.find_first_not_of("# "), std::string_view::npos) << letter;
    }
  }
}

TEST(PictureFont, NoTwoLettersLookTheSame) {
  std::set<Glyph> looks;
  for (const char letter : kLetters) {
    looks.insert(*glyph_of(letter));
  }
  EXPECT_EQ(looks.size(), kLetters.size());
}

TEST(PictureFont, HasNothingForABlank) {
  EXPECT_EQ(glyph_of(' '), nullptr);
  EXPECT_EQ(glyph_of('A'), nullptr);
}

}  // namespace
}  // namespace echomap::exports
