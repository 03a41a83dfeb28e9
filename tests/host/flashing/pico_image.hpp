// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include "host/files/atomic_file.hpp"
#include "host/flashing/rp2040_image.hpp"

namespace echomap::flashing {

inline void put_little_endian(Bytes& image, std::size_t at, std::uint32_t word) {
  for (std::size_t i = 0; i < 4; ++i) {
    image[at + i] = static_cast<std::uint8_t>(word >> (8 * i));
  }
}

/// An image of `size` bytes that an RP2040 would start.
inline Bytes pico_image(std::size_t size) {
  Bytes image(size);
  for (std::size_t i = 0; i < size; ++i) {
    image[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  }
  put_little_endian(image, 252, boot_checksum(std::span(image).first(252)));
  put_little_endian(image, 256, 0x20040000);
  put_little_endian(image, 260, kFlashBegin + 0x1c1);
  return image;
}

inline void write_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  files::write_text_file(path, std::string(bytes.begin(), bytes.end()));
}

inline Bytes read_bytes(const std::filesystem::path& path) {
  const std::string text = files::read_text_file(path);
  return {text.begin(), text.end()};
}

}  // namespace echomap::flashing
