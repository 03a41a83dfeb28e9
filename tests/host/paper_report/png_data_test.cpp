// SPDX-License-Identifier: MIT
#include "host/paper_report/png_data.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/paper_report/base64_decoder.hpp"
#include "tests/host/paper_report/tiny_png.hpp"

namespace echomap::paper_report {
namespace {

std::string base64_of_text(std::string_view text) {
  return base64_of(std::vector<std::uint8_t>(text.begin(), text.end()));
}

// The test vectors of RFC 4648, section 10.
TEST(Base64, HasTheVectorsOfItsStandard) {
  EXPECT_EQ(base64_of_text(""), "");
  EXPECT_EQ(base64_of_text("f"), "Zg==");
  EXPECT_EQ(base64_of_text("fo"), "Zm8=");
  EXPECT_EQ(base64_of_text("foo"), "Zm9v");
  EXPECT_EQ(base64_of_text("foob"), "Zm9vYg==");
  EXPECT_EQ(base64_of_text("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64_of_text("foobar"), "Zm9vYmFy");
}

TEST(Base64, OfEveryByteIsDecodedToIt) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 256; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(255 - i));
    EXPECT_EQ(tests::base64_decoded(base64_of(bytes)), bytes) << bytes.size() << " bytes";
  }
}

TEST(PngDataUri, HoldsTheWholeFile) {
  const std::vector<std::uint8_t> png = tiny_png(3, 2);
  const std::string uri = png_data_uri(png);
  const std::string start = "data:image/png;base64,";
  ASSERT_EQ(uri.substr(0, start.size()), start);
  EXPECT_EQ(tests::base64_decoded(uri.substr(start.size())), png);
}

TEST(PngSize, IsThatOfThePicture) {
  EXPECT_EQ(png_size(tiny_png(300, 2)), (PngSize{.width_px = 300, .height_px = 2}));
}

TEST(PngSize, IsEmptyForOtherBytes) {
  std::vector<std::uint8_t> png = tiny_png(3, 2);
  EXPECT_FALSE(png_size({}).has_value());
  EXPECT_FALSE(png_size(std::span(png).first(23)).has_value());
  EXPECT_TRUE(png_size(std::span(png).first(24)).has_value());
  png[1] = 'Q';
  EXPECT_FALSE(png_size(png).has_value());
}

}  // namespace
}  // namespace echomap::paper_report
