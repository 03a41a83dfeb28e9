// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace echomap::paper_report {

/// Width and height of a picture, pixels.
struct PngSize {
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;

  bool operator==(const PngSize&) const = default;
};

/// Bytes as letters: base64 with padding and without line breaks (RFC 4648, section 4).
std::string base64_of(std::span<const std::uint8_t> bytes);

/// A PNG file as a `data:` address, which a page holds in itself.
std::string png_data_uri(std::span<const std::uint8_t> png);

/// Size by the header of a PNG file; empty for bytes that are none.
std::optional<PngSize> png_size(std::span<const std::uint8_t> png);

}  // namespace echomap::paper_report
