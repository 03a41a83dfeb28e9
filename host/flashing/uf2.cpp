// SPDX-License-Identifier: MIT
#include "host/flashing/uf2.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace echomap::flashing {
namespace {

constexpr std::size_t kBlockBytes = 512;
constexpr std::size_t kPageBytes = 256;
constexpr std::size_t kSectorBytes = 4096;
constexpr std::size_t kDataOffset = 32;

constexpr std::uint32_t kFirstMagic = 0x0a324655;  // "UF2\n"
constexpr std::uint32_t kSecondMagic = 0x9e5d5157;
constexpr std::uint32_t kLastMagic = 0x0ab16f30;
constexpr std::uint32_t kFamilyIsGiven = 0x00002000;
constexpr std::uint32_t kRp2040Family = 0xe48bff56;

/// Offsets of a block's words.
constexpr std::size_t kFlags = 8;
constexpr std::size_t kAddress = 12;
constexpr std::size_t kLength = 16;
constexpr std::size_t kNumber = 20;
constexpr std::size_t kCount = 24;
constexpr std::size_t kFamily = 28;
constexpr std::size_t kEnd = 508;

void put_word(std::span<std::uint8_t> block, std::size_t at, std::uint32_t word) {
  for (std::size_t i = 0; i < 4; ++i) {
    block[at + i] = static_cast<std::uint8_t>(word >> (8 * i));
  }
}

std::uint32_t word_at(std::span<const std::uint8_t> block, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= std::uint32_t{block[at + i]} << (8 * i);
  }
  return word;
}

/// What is wrong with block `number` of `count`; empty where nothing is.
std::string fault_of(std::span<const std::uint8_t> block, std::size_t number, std::size_t count) {
  if (word_at(block, 0) != kFirstMagic || word_at(block, 4) != kSecondMagic ||
      word_at(block, kEnd) != kLastMagic) {
    return "it does not have the marks of UF2";
  }
  if ((word_at(block, kFlags) & kFamilyIsGiven) == 0 || word_at(block, kFamily) != kRp2040Family) {
    return "it is for another chip than the RP2040";
  }
  if (word_at(block, kNumber) != number || word_at(block, kCount) != count) {
    return fmt::format("it says that it is block {} of {}",
                       std::uint64_t{word_at(block, kNumber)} + 1,
                       word_at(block, kCount));
  }
  if (word_at(block, kLength) != kPageBytes ||
      word_at(block, kAddress) != kFlashBegin + number * kPageBytes) {
    return "it does not follow the block before it";
  }
  return "";
}

}  // namespace

Bytes uf2_of(std::span<const std::uint8_t> image) {
  const std::size_t sectors = (image.size() + kSectorBytes - 1) / kSectorBytes;
  const std::size_t blocks = sectors * (kSectorBytes / kPageBytes);
  Bytes file(blocks * kBlockBytes, 0);
  for (std::size_t number = 0; number < blocks; ++number) {
    const std::size_t at = number * kPageBytes;
    const auto block = std::span(file).subspan(number * kBlockBytes, kBlockBytes);
    put_word(block, 0, kFirstMagic);
    put_word(block, 4, kSecondMagic);
    put_word(block, kFlags, kFamilyIsGiven);
    put_word(block, kAddress, static_cast<std::uint32_t>(kFlashBegin + at));
    put_word(block, kLength, kPageBytes);
    put_word(block, kNumber, static_cast<std::uint32_t>(number));
    put_word(block, kCount, static_cast<std::uint32_t>(blocks));
    put_word(block, kFamily, kRp2040Family);
    put_word(block, kEnd, kLastMagic);
    const auto data = block.subspan(kDataOffset, kPageBytes);
    std::ranges::fill(data, std::uint8_t{0xff});
    const std::size_t begin = std::min(at, image.size());
    std::ranges::copy(image.subspan(begin, std::min(kPageBytes, image.size() - begin)),
                      data.begin());
  }
  return file;
}

bool begins_as_uf2(std::span<const std::uint8_t> file) {
  return file.size() >= 8 && word_at(file, 0) == kFirstMagic && word_at(file, 4) == kSecondMagic;
}

Bytes image_in_uf2(std::span<const std::uint8_t> file) {
  if (file.empty() || file.size() % kBlockBytes != 0) {
    throw Uf2Error(
        fmt::format("it has {} bytes, which are no whole blocks of {}", file.size(), kBlockBytes));
  }
  const std::size_t count = file.size() / kBlockBytes;
  Bytes image;
  image.reserve(count * kPageBytes);
  for (std::size_t number = 0; number < count; ++number) {
    const auto block = file.subspan(number * kBlockBytes, kBlockBytes);
    if (const std::string fault = fault_of(block, number, count); !fault.empty()) {
      throw Uf2Error(fmt::format("block {} of {}: {}", number + 1, count, fault));
    }
    const auto data = block.subspan(kDataOffset, kPageBytes);
    image.insert(image.end(), data.begin(), data.end());
  }
  return image;
}

}  // namespace echomap::flashing
