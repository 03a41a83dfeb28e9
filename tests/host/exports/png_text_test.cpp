// SPDX-License-Identifier: MIT
#include "host/exports/png_text.hpp"

#include <png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/picture.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/png_texts.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

const std::vector<PngText> kTexts{{"resolution", "0.05"}, {"origin", "[-1.5, 2, 0]"}};

class PngTextTest : public ::testing::Test {
 protected:
  PngTextTest() { Picture(7, 5, {1, 2, 3}).write_png(path, kTexts); }
  std::string complaint_about(const std::string& bytes) {
    files::write_text_file(folder / "b.png", bytes);
    return tests::thrown_text<files::FileError>([&] { tests::read_png_texts(folder / "b.png"); });
  }

  tests::ScratchFolder folder;
  std::filesystem::path path = folder / "a.png";
};

TEST_F(PngTextTest, IsReadBack) { EXPECT_EQ(tests::read_png_texts(path), kTexts); }

TEST_F(PngTextTest, IsWhatLibpngFinds) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_read_info(png, info);  // Ends the program where a checksum is wrong.
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(png, info, &texts, &count);
  ASSERT_EQ(count, 2);
  EXPECT_STREQ(texts[0].key, "resolution");
  EXPECT_STREQ(texts[0].text, "0.05");
  EXPECT_STREQ(texts[1].text, "[-1.5, 2, 0]");
  EXPECT_EQ(png_get_image_width(png, info), 7U);
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(file);
}

TEST_F(PngTextTest, OfAPictureWithoutTextsIsEmpty) {
  Picture(1, 1, {0, 0, 0}).write_png(folder / "c.png");
  EXPECT_TRUE(tests::read_png_texts(folder / "c.png").empty());
}

TEST_F(PngTextTest, NamesTheFileThatIsNoneOrIsCutShort) {
  const std::string whole = files::read_text_file(path);
  EXPECT_THAT(complaint_about("GIF89a"), HasSubstr("b.png: not a PNG"));
  EXPECT_THAT(complaint_about(""), HasSubstr("b.png: not a PNG"));
  for (const std::size_t length : {9UL, 40UL, whole.size() - 1}) {
    EXPECT_THAT(complaint_about(whole.substr(0, length)), HasSubstr("within a chunk")) << length;
  }
}

}  // namespace
}  // namespace echomap::exports
