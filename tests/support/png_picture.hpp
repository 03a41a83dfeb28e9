// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <png.h>
#include <vector>

namespace echomap::tests {

/// A PNG file as libpng reads it, a pixel as 0xRRGGBB.
struct PngPicture {
  explicit PngPicture(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    png_image_begin_read_from_file(&image, path.c_str());
    image.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr);
    width = static_cast<int>(image.width);
    height = static_cast<int>(image.height);
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
      pixels.push_back(bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2]);
    }
  }
  int at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }

  int width = 0;
  int height = 0;
  std::vector<int> pixels;
};

}  // namespace echomap::tests
