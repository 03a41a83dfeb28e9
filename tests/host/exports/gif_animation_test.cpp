// SPDX-License-Identifier: MIT
#include "host/exports/gif_animation.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/gif_pictures.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kRed{255, 0, 0};

Picture with_mark(int x, int y) {
  Picture picture(20, 10, kWhite);
  picture.set(x, y, kRed);
  return picture;
}

/// A picture of that many greens.
Picture greens(int count) {
  Picture picture(20, 20, kWhite);
  for (int i = 0; i < count; ++i) {
    picture.set(
        i % 20, i / 20, {static_cast<std::uint8_t>(i / 256), static_cast<std::uint8_t>(i), 0});
  }
  return picture;
}

int rgb(Colour colour) { return colour.red << 16 | colour.green << 8 | colour.blue; }

TEST(GifAnimation, ShowsEachPictureForItsTimeAndRepeatsForEver) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  animation.add(with_mark(3, 4), 400);
  animation.add(with_mark(5, 6), 1230);
  animation.save(folder / "a.gif");
  const tests::GifPictures gif(folder / "a.gif");
  EXPECT_EQ(gif.width, 20);
  EXPECT_EQ(gif.height, 10);
  EXPECT_EQ(gif.repetitions, 0);
  ASSERT_EQ(gif.images.size(), 2U);
  EXPECT_EQ(gif.images[0].control.DelayTime, 40);
  EXPECT_EQ(gif.images[1].control.DelayTime, 123);
  EXPECT_EQ(gif.at(0, 3, 4), 0xFF0000);
  EXPECT_EQ(gif.at(1, 3, 4), 0xFFFFFF);
  EXPECT_EQ(gif.at(1, 5, 6), 0xFF0000);
}

TEST(GifAnimation, StoresOnlyTheRectangleThatChanged) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  animation.add(with_mark(3, 4), 100);
  animation.add(with_mark(8, 6), 100);
  animation.save(folder / "a.gif");
  const GifImageDesc place = tests::GifPictures(folder / "a.gif").images[1].place;
  EXPECT_EQ(place.Left, 3);
  EXPECT_EQ(place.Top, 4);
  EXPECT_EQ(place.Width, 6);
  EXPECT_EQ(place.Height, 3);
}

TEST(GifAnimation, OfTheSamePictureTwiceHasTwoFrames) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  animation.add(with_mark(3, 4), 100);
  animation.add(with_mark(3, 4), 100);
  animation.save(folder / "a.gif");
  const tests::GifPictures gif(folder / "a.gif");
  ASSERT_EQ(gif.images.size(), 2U);
  EXPECT_EQ(gif.images[0].shown, gif.images[1].shown);
}

TEST(GifAnimation, KeepsUpTo255ColoursExactly) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  const Picture picture = greens(254);
  animation.add(picture, 100);
  animation.save(folder / "a.gif");
  const tests::GifPictures gif(folder / "a.gif");
  EXPECT_EQ(gif.colours, 256);
  for (int i = 0; i < 400; ++i) {
    EXPECT_EQ(gif.at(0, i % 20, i / 20), rgb(picture.at(i % 20, i / 20))) << i;
  }
}

TEST(GifAnimation, ShowsTheNearestOfManyColoursAndTheNamedOnesExactly) {
  const tests::ScratchFolder folder;
  GifAnimation animation({kWhite, kRed});
  Picture picture = greens(350);
  picture.set(19, 19, kRed);
  animation.add(picture, 100);
  animation.save(folder / "a.gif");
  const tests::GifPictures gif(folder / "a.gif");
  EXPECT_EQ(gif.at(0, 19, 19), 0xFF0000);
  EXPECT_EQ(gif.at(0, 18, 19), 0xFFFFFF);
  for (int i = 0; i < 350; ++i) {
    const int green = gif.at(0, i % 20, i / 20) >> 8 & 0xFF;
    EXPECT_NEAR(green, picture.at(i % 20, i / 20).green, 4) << i;
  }
}

TEST(GifAnimation, OfFewColoursHasASmallPalette) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  animation.add(with_mark(3, 4), 100);
  animation.save(folder / "a.gif");
  EXPECT_EQ(tests::GifPictures(folder / "a.gif").colours, 4) << "two, and that for no change";
}

TEST(GifAnimation, NeverShowsAPictureForLessThanViewersDo) {
  const tests::ScratchFolder folder;
  GifAnimation animation;
  animation.add(with_mark(3, 4), 0);
  animation.save(folder / "a.gif");
  EXPECT_EQ(tests::GifPictures(folder / "a.gif").images[0].control.DelayTime, 2);
}

TEST(GifAnimation, RefusesPicturesOfAnotherSize) {
  GifAnimation animation;
  animation.add(with_mark(3, 4), 100);
  EXPECT_THROW(animation.add(Picture(21, 10, kWhite), 100), std::invalid_argument);
  EXPECT_THROW(GifAnimation().add(Picture(70000, 1, kWhite), 100), std::invalid_argument);
}

TEST(GifAnimation, OfNothingIsNoFile) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(GifAnimation().save(folder / "a.gif"), files::FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.gif"));
}

}  // namespace
}  // namespace echomap::exports
