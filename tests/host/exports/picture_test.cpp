// SPDX-License-Identifier: MIT
#include "host/exports/picture.hpp"

#include <png.h>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kInk{10, 20, 30};

std::vector<std::string> drawing_of(const Picture& picture) {
  std::vector<std::string> drawing;
  for (int y = 0; y < picture.height(); ++y) {
    std::string line;
    for (int x = 0; x < picture.width(); ++x) {
      line.push_back(picture.at(x, y) == kInk ? '#' : '.');
    }
    drawing.push_back(line);
  }
  return drawing;
}

using Drawing = std::vector<std::string>;

TEST(Picture, WritesDigitsThatCanBeRead) {
  Picture picture(29, 7, kWhite);
  picture.draw_text(0, 0, "2.5 m", 1, kInk);
  EXPECT_EQ(drawing_of(picture),
            (Drawing{".###........#####............",
                     "#...#.......#................",
                     "....#.......####........##.#.",
                     "...#............#.......#.#.#",
                     "..#.............#.......#.#.#",
                     ".#.....##...#...#.......#.#.#",
                     "#####..##....###........#.#.#"}));
}

TEST(Picture, ScalesItsText) {
  Picture picture(13, 14, kWhite);
  picture.draw_text(0, 0, "1", 2, kInk);
  const Drawing drawing = drawing_of(picture);
  EXPECT_EQ(drawing[0], "....##.......");
  EXPECT_EQ(drawing[1], drawing[0]);
  EXPECT_EQ(drawing[13], "..######.....");
}

TEST(Picture, DrawsALineOfItsWidth) {
  Picture picture(8, 5, kWhite);
  picture.draw_line({1.5, 2.5}, {5.5, 2.5}, 1.0, kInk);
  EXPECT_EQ(drawing_of(picture),
            (Drawing{"........", "........", ".#####..", "........", "........"}));
}

TEST(Picture, DrawsADisc) {
  Picture picture(7, 7, kWhite);
  picture.fill_disc({3.5, 3.5}, 2.3, kInk);
  EXPECT_EQ(drawing_of(picture),
            (Drawing{".......", "..###..", ".#####.", ".#####.", ".#####.", "..###..", "......."}));
}

TEST(Picture, CutsOffWhatFallsOutside) {
  Picture picture(3, 3, kWhite);
  picture.fill_rectangle(-5, -5, 100, 100, kInk);
  picture.draw_line({-20.0, 1.0}, {50.0, 1.0}, 2.0, kInk);
  EXPECT_EQ(drawing_of(picture), (Drawing{"###", "###", "###"}));
}

TEST(Picture, IsThePngThatLibpngReads) {
  const tests::ScratchFolder folder;
  Picture picture(5, 3, kWhite);
  picture.set(4, 2, kInk);
  picture.write_png(folder / "a.png");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, (folder / "a.png").c_str()), 0);
  EXPECT_EQ(image.width, 5U);
  EXPECT_EQ(image.height, 3U);
  image.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels[0], 255);
  EXPECT_EQ((std::vector<unsigned char>(pixels.end() - 3, pixels.end())),
            (std::vector<unsigned char>{10, 20, 30}));
}

TEST(Picture, SaysWhyItCannotBeWritten) {
  EXPECT_THROW(Picture(2, 2, kWhite).write_png("/nowhere/a.png"), files::FileError);
}

TEST(Picture, DrawsOnlyOnTheRowsItIsLimitedTo) {
  Picture picture(4, 6, {255, 255, 255});
  picture.limit_rows(2, 4);
  picture.fill_rectangle(0, 0, 4, 6, {0, 0, 0});
  picture.blend(1, 5, {0, 0, 0}, 1.0);
  for (int y = 0; y < 6; ++y) {
    EXPECT_EQ(picture.at(1, y).red, y == 2 || y == 3 ? 0 : 255) << y;
  }
}

}  // namespace
}  // namespace echomap::exports
