// SPDX-License-Identifier: MIT
/// What the boot program of a Pico wants of the release image.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/firmware/boards/rp2040/boot2_checksum.hpp"

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
  ASSERT_GT(image.size(), kBoot2CheckedBytes);
  EXPECT_EQ(word_at(image, kBoot2CheckedBytes),
            checksum_of(std::span(image).first(kBoot2CheckedBytes)));
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
