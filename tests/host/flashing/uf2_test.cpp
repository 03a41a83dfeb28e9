// SPDX-License-Identifier: MIT
#include "host/flashing/uf2.hpp"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/flashing/pico_image.hpp"

namespace echomap::flashing {
namespace {

using testing::Each;
using testing::HasSubstr;

std::uint32_t word_of(const Bytes& file, std::size_t at) {
  return std::uint32_t{file[at]} | std::uint32_t{file[at + 1]} << 8 |
         std::uint32_t{file[at + 2]} << 16 | std::uint32_t{file[at + 3]} << 24;
}

std::string error_of(const Bytes& file) {
  try {
    image_in_uf2(file);
  } catch (const Uf2Error& error) {
    return error.what();
  }
  return "no error";
}

/// A good file with one word changed.
std::string error_with(std::size_t at, std::uint32_t word) {
  Bytes file = uf2_of(pico_image(5000));
  put_little_endian(file, at, word);
  return error_of(file);
}

TEST(Uf2, WritesTheWordsOfTheFormatByteForByte) {
  const Bytes image = pico_image(300);
  const Bytes file = uf2_of(image);
  ASSERT_EQ(file.size(), 16U * 512) << "one sector of 4 kB";
  // Block 1 of 16: magic, magic, family is given, 10000100, 256 bytes, 1, 16, RP2040.
  const std::array<std::uint8_t, 32> header{0x55, 0x46, 0x32, 0x0a, 0x57, 0x51, 0x5d, 0x9e,
                                            0x00, 0x20, 0x00, 0x00, 0x00, 0x01, 0x00, 0x10,
                                            0x00, 0x01, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00,
                                            0x10, 0x00, 0x00, 0x00, 0x56, 0xff, 0x8b, 0xe4};
  EXPECT_TRUE(std::equal(header.begin(), header.end(), file.begin() + 512));
  EXPECT_EQ(word_of(file, 512 + 508), 0x0ab16f30U);
  EXPECT_TRUE(std::equal(image.begin(), image.begin() + 256, file.begin() + 32));
  EXPECT_TRUE(std::equal(image.begin() + 256, image.end(), file.begin() + 512 + 32));
}

TEST(Uf2, FillsTheLastSectorAsErasedFlash) {
  const Bytes image = pico_image(4096 + 1);
  const Bytes back = image_in_uf2(uf2_of(image));
  ASSERT_EQ(back.size(), 2U * 4096);
  EXPECT_TRUE(std::equal(image.begin(), image.end(), back.begin()));
  EXPECT_THAT(Bytes(back.begin() + 4097, back.end()), Each(0xff));
  EXPECT_EQ(image_in_uf2(uf2_of(pico_image(8192))), pico_image(8192)) << "nothing to fill";
}

TEST(Uf2, ReadsWhatItWritesForEveryLength) {
  for (const std::size_t size : {264U, 511U, 512U, 4095U, 4096U, 22000U, 2097152U}) {
    const Bytes image = pico_image(size);
    Bytes back = image_in_uf2(uf2_of(image));
    back.resize(size);
    EXPECT_EQ(back, image) << size;
  }
}

TEST(Uf2, IsKnownByItsBeginning) {
  EXPECT_TRUE(begins_as_uf2(uf2_of(pico_image(300))));
  EXPECT_FALSE(begins_as_uf2(pico_image(300)));
  EXPECT_FALSE(begins_as_uf2({}));
}

TEST(Uf2, PlacesWhatIsWrong) {
  EXPECT_THAT(error_of({}), HasSubstr("0 bytes"));
  Bytes cut = uf2_of(pico_image(300));
  cut.resize(cut.size() - 100);
  EXPECT_THAT(error_of(cut), HasSubstr("no whole blocks of 512"));
  cut.resize(512 * 15);
  EXPECT_THAT(error_of(cut), HasSubstr("block 1 of 15: it says that it is block 1 of 16"));
  EXPECT_THAT(error_with(512, 0), HasSubstr("block 2 of 32: it does not have the marks"));
  EXPECT_THAT(error_with(508, 0), HasSubstr("marks"));
  EXPECT_THAT(error_with(2 * 512 + 20, 3), HasSubstr("block 3 of 32: it says"));
  EXPECT_THAT(error_with(512 + 12, kFlashBegin), HasSubstr("does not follow"));
  EXPECT_THAT(error_with(512 + 16, 476), HasSubstr("does not follow"));
}

TEST(Uf2, IsNotTakenForAnotherChip) {
  EXPECT_THAT(error_with(28, 0xe48bff59), HasSubstr("another chip")) << "an RP2350";
  EXPECT_THAT(error_with(8, 0), HasSubstr("another chip")) << "no family is given";
}

}  // namespace
}  // namespace echomap::flashing
