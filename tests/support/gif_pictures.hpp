// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <gif_lib.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace echomap::tests {

/// A GIF file as giflib reads it: what a viewer shows, picture by picture, a pixel as 0xRRGGBB.
struct GifPictures {
  /// What one image of the file says.
  struct Image {
    GifImageDesc place;  ///< Left, Top, Width and Height.
    GraphicsControlBlock control;
    std::vector<int> shown;  ///< The whole picture after it, row by row.
  };

  explicit GifPictures(const std::filesystem::path& path) {
    const auto close = [](GifFileType* gif) { DGifCloseFile(gif, nullptr); };
    const std::unique_ptr<GifFileType, decltype(close)> gif(DGifOpenFileName(path.c_str(), nullptr),
                                                            close);
    if (!gif || DGifSlurp(gif.get()) != GIF_OK) {
      throw std::runtime_error(path.string() + ": no GIF");
    }
    width = gif->SWidth;
    height = gif->SHeight;
    colours = gif->SColorMap->ColorCount;
    read_repetition(gif->SavedImages[0]);
    std::vector<int> shown(static_cast<std::size_t>(width * height), -1);
    for (int i = 0; i < gif->ImageCount; ++i) {
      const SavedImage& image = gif->SavedImages[i];
      GraphicsControlBlock control{};
      DGifSavedExtensionToGCB(gif.get(), i, &control);
      lay(image, control.TransparentColor, *gif->SColorMap, shown);
      images.push_back({image.ImageDesc, control, shown});
    }
  }
  int at(std::size_t image, int x, int y) const {
    return images[image].shown[static_cast<std::size_t>(y * width + x)];
  }

  int width = 0;
  int height = 0;
  int colours = 0;
  int repetitions = -1;  ///< By the extension NETSCAPE2.0, 0 for ever; -1 without it.
  std::vector<Image> images;

 private:
  void read_repetition(const SavedImage& first) {
    for (int i = 0; i + 1 < first.ExtensionBlockCount; ++i) {
      const ExtensionBlock& name = first.ExtensionBlocks[i];
      const ExtensionBlock& data = first.ExtensionBlocks[i + 1];
      const bool is_loop = name.Function == APPLICATION_EXT_FUNC_CODE && name.ByteCount == 11 &&
                           std::string(name.Bytes, name.Bytes + 11) == "NETSCAPE2.0";
      if (is_loop && data.ByteCount == 3 && data.Bytes[0] == 1) {
        repetitions = data.Bytes[1] | data.Bytes[2] << 8;
      }
    }
  }
  void lay(const SavedImage& image,
           int transparent,
           const ColorMapObject& colour_map,
           std::vector<int>& shown) const {
    const GifImageDesc& place = image.ImageDesc;
    for (int y = 0; y < place.Height; ++y) {
      for (int x = 0; x < place.Width; ++x) {
        const int index = image.RasterBits[y * place.Width + x];
        if (index != transparent) {
          const GifColorType& colour = colour_map.Colors[index];
          shown[static_cast<std::size_t>((place.Top + y) * width + place.Left + x)] =
              colour.Red << 16 | colour.Green << 8 | colour.Blue;
        }
      }
    }
  }
};

}  // namespace echomap::tests
