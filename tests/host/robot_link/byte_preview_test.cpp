// SPDX-License-Identifier: MIT
#include "host/robot_link/byte_preview.hpp"

#include <string_view>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

BytePreview preview_of(std::string_view text) {
  BytePreview preview;
  for (const char character : text) {
    preview.add(static_cast<std::uint8_t>(character));
  }
  return preview;
}

TEST(BytePreview, ShowsHexadecimalBesidePrintable) {
  EXPECT_EQ(preview_of("echo: 42\r\n\xFF").text(),
            "65 63 68 6f 3a 20 34 32 0d 0a ff                 |echo: 42...|\n");
}

TEST(BytePreview, BreaksLinesAfterSixteenBytes) {
  EXPECT_EQ(preview_of("0123456789abcdefg").text(),
            "30 31 32 33 34 35 36 37 38 39 61 62 63 64 65 66  |0123456789abcdef|\n"
            "67                                               |g|\n");
}

TEST(BytePreview, KeepsTheFirst64BytesOnly) {
  BytePreview preview;
  for (int i = 0; i < 1000; ++i) {
    preview.add(static_cast<std::uint8_t>(i));
  }
  ASSERT_EQ(preview.bytes().size(), 64U);
  EXPECT_EQ(preview.bytes().back(), 63);
}

TEST(BytePreview, IsEmptyAfterClear) {
  BytePreview preview = preview_of("abc");
  preview.clear();
  EXPECT_EQ(preview.text(), "");
}

}  // namespace
}  // namespace echomap::robot_link
