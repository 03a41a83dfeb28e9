// SPDX-License-Identifier: MIT
/// What the boot program of a Pico checks in the image, which no emulator does.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::boards {
namespace {

using ImageBytes = std::vector<std::uint8_t>;

ImageBytes release_image_bytes() {
  const std::filesystem::path path = ECHOMAP_BINARY_DIR "/firmware/echomap-pico.bin";
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::uint32_t word_at(const ImageBytes& image, std::size_t at) {
  return std::uint32_t{image.at(at)} | std::uint32_t{image.at(at + 1)} << 8 |
         std::uint32_t{image.at(at + 2)} << 16 | std::uint32_t{image.at(at + 3)} << 24;
}

TEST(PicoImage, BeginsWithASecondStageOfTheRightChecksum) {
  const ImageBytes image = release_image_bytes();
  std::uint32_t remainder = 0xFFFFFFFF;
  for (std::size_t at = 0; at < std::size_t{252} * 8; ++at) {
    const std::uint32_t in = image.at(at / 8) >> (7 - at % 8) & 1U;
    const std::uint32_t out = remainder >> 31;
    remainder = (remainder << 1) ^ ((in ^ out) != 0 ? 0x04C11DB7U : 0U);
  }
  EXPECT_EQ(word_at(image, 252), remainder);
}

TEST(PicoImage, TheVectorsBehindItAreAStackInRamAndAStartInTheFlash) {
  const ImageBytes image = release_image_bytes();
  EXPECT_EQ(word_at(image, 256), 0x2000A000U);
  const std::uint32_t start = word_at(image, 260);
  EXPECT_EQ(start & 1, 1U) << "Thumb";
  EXPECT_GT(start, 0x10000100U);
  EXPECT_LT(start, 0x10000000U + image.size());
}

}  // namespace
}  // namespace echomap::boards
