// SPDX-License-Identifier: MIT
#include "host/paper_report/png_data.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace echomap::paper_report {
namespace {

constexpr std::string_view kBase64Letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kGroupBytes = 3;
constexpr std::size_t kGroupLetters = 4;

/// What a PNG file begins with: its signature, then length and name of the chunk with the size.
constexpr std::array<std::uint8_t, 16> kPngStart{
    0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'};

std::uint32_t big_endian_32(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    value = value << 8U | bytes[i];
  }
  return value;
}

}  // namespace

std::string base64_of(std::span<const std::uint8_t> bytes) {
  std::string letters;
  letters.reserve((bytes.size() + 2) / kGroupBytes * kGroupLetters);
  for (std::size_t at = 0; at < bytes.size(); at += kGroupBytes) {
    const std::size_t count = std::min(kGroupBytes, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < kGroupBytes; ++i) {
      group = group << 8U | (i < count ? bytes[at + i] : 0U);
    }
    for (std::size_t i = 0; i < kGroupLetters; ++i) {
      letters += i <= count ? kBase64Letters[group >> (18U - 6U * i) & 0x3FU] : '=';
    }
  }
  return letters;
}

std::string png_data_uri(std::span<const std::uint8_t> png) {
  return "data:image/png;base64," + base64_of(png);
}

std::optional<PngSize> png_size(std::span<const std::uint8_t> png) {
  constexpr std::size_t kHeightAt = kPngStart.size() + 4;
  if (png.size() < kHeightAt + 4 || !std::equal(kPngStart.begin(), kPngStart.end(), png.begin())) {
    return std::nullopt;
  }
  return PngSize{.width_px = big_endian_32(png, kPngStart.size()),
                 .height_px = big_endian_32(png, kHeightAt)};
}

}  // namespace echomap::paper_report
