// SPDX-License-Identifier: MIT
#include "host/exports/gif_animation.hpp"

#include <algorithm>
#include <gif_lib.h>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {
namespace {

/// One of the 256 indices stands for a pixel that stays as it is.
constexpr std::size_t kMaxColours = 255;
constexpr std::uint8_t kUnchanged = 255;
constexpr int kMinDurationCs = 2;
constexpr int kMaxDurationCs = std::numeric_limits<std::uint16_t>::max();
constexpr int kMaxSidePx = std::numeric_limits<std::uint16_t>::max();
/// Of a screen's colour, as the header of a file has it.
constexpr int kBitsPerChannel = 8;
constexpr std::string_view kLoopName = "NETSCAPE2.0";
/// Sub-block 1: how often to repeat, low byte first; 0 is for ever.
constexpr std::array<unsigned char, 3> kLoopForEver{1, 0, 0};

int squared_distance(Colour a, Colour b) {
  const int red = a.red - b.red;
  const int green = a.green - b.green;
  const int blue = a.blue - b.blue;
  return red * red + green * green + blue * blue;
}

int append_to_string(GifFileType* gif, const GifByteType* bytes, int count) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

/// The least power of two that is enough, as a palette has it.
int palette_size(std::size_t colours) {
  int size = 2;
  while (static_cast<std::size_t>(size) < colours) {
    size *= 2;
  }
  return size;
}

struct ClosesGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};

struct FreesColours {
  void operator()(ColorMapObject* colours) const { GifFreeMapObject(colours); }
};

void expect_gif(int status) {
  if (status != GIF_OK) {
    throw std::runtime_error("the encoder of GIF files failed");
  }
}

/// A GIF file in memory, frame by frame.
class GifStream {
 public:
  GifStream(int width_px, int height_px, const std::vector<Colour>& palette)
      : transparent_(static_cast<std::uint8_t>(palette.size())),
        gif_(EGifOpen(&bytes_, append_to_string, nullptr)) {
    expect_gif(gif_ ? GIF_OK : GIF_ERROR);
    EGifSetGifVersion(gif_.get(), true);
    const std::unique_ptr<ColorMapObject, FreesColours> colours(
        GifMakeMapObject(palette_size(palette.size() + 1), nullptr));
    expect_gif(colours ? GIF_OK : GIF_ERROR);
    for (std::size_t i = 0; i < palette.size(); ++i) {
      colours->Colors[i] = {palette[i].red, palette[i].green, palette[i].blue};
    }
    expect_gif(
        EGifPutScreenDesc(gif_.get(), width_px, height_px, kBitsPerChannel, 0, colours.get()));
  }

  void repeat_for_ever() {
    const auto size = static_cast<int>(kLoopName.size());
    const auto loop_size = static_cast<int>(kLoopForEver.size());
    expect_gif(EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE));
    expect_gif(EGifPutExtensionBlock(gif_.get(), size, kLoopName.data()));
    expect_gif(EGifPutExtensionBlock(gif_.get(), loop_size, kLoopForEver.data()));
    expect_gif(EGifPutExtensionTrailer(gif_.get()));
  }

  void write(const GifFrame& frame) {
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, frame.duration_cs, transparent_};
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    expect_gif(EGifPutExtension(
        gif_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(extension.size()), extension.data()));
    expect_gif(EGifPutImageDesc(
        gif_.get(), frame.left_px, frame.top_px, frame.width_px, frame.height_px, false, nullptr));
    std::vector<std::uint8_t> indices = frame.indices;
    std::replace(indices.begin(), indices.end(), kUnchanged, transparent_);
    const auto width = static_cast<std::size_t>(frame.width_px);
    for (std::size_t begin = 0; begin < indices.size(); begin += width) {
      expect_gif(EGifPutLine(gif_.get(), &indices[begin], frame.width_px));
    }
  }

  /// The whole file; nothing can be written after it.
  std::string finish() {
    expect_gif(EGifCloseFile(gif_.release(), nullptr));
    return std::move(bytes_);
  }

 private:
  std::uint8_t transparent_;
  std::string bytes_;
  std::unique_ptr<GifFileType, ClosesGif> gif_;
};

/// Where two pictures of the same width differ.
struct PixelBounds {
  int left;
  int top;
  int right;
  int bottom;
};

PixelBounds changed_bounds(const std::vector<std::uint8_t>& before,
                           const std::vector<std::uint8_t>& now,
                           int width) {
  const int height = static_cast<int>(now.size()) / width;
  PixelBounds changed{width, height, -1, -1};
  std::size_t pixel = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++pixel) {
      if (before[pixel] != now[pixel]) {
        changed = {
            std::min(changed.left, x), std::min(changed.top, y), std::max(changed.right, x), y};
      }
    }
  }
  return changed;
}

}  // namespace

GifAnimation::GifAnimation(const std::vector<Colour>& exact) {
  for (const Colour colour : exact) {
    if (palette_.size() == kMaxColours) {
      throw std::invalid_argument("gif animation: more than 255 exact colours");
    }
    index_of(colour);
  }
}

std::uint8_t GifAnimation::index_of(Colour colour) {
  const auto [at, is_new] = known_.try_emplace({colour.red, colour.green, colour.blue});
  if (is_new) {
    if (palette_.size() < kMaxColours) {
      at->second = static_cast<std::uint8_t>(palette_.size());
      palette_.push_back(colour);
    } else {
      at->second = nearest_index(colour);
    }
  }
  return at->second;
}

std::uint8_t GifAnimation::nearest_index(Colour colour) const {
  const auto nearest =
      std::min_element(palette_.begin(), palette_.end(), [&](Colour first, Colour second) {
        return squared_distance(first, colour) < squared_distance(second, colour);
      });
  return static_cast<std::uint8_t>(nearest - palette_.begin());
}

std::vector<std::uint8_t> GifAnimation::indices_of(const Picture& picture) {
  std::vector<std::uint8_t> indices;
  indices.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Colour colour = picture.at(x, y);
      // Neighbours are mostly alike.
      const bool is_last = !indices.empty() && palette_[indices.back()] == colour;
      indices.push_back(is_last ? indices.back() : index_of(colour));
    }
  }
  return indices;
}

GifFrame GifAnimation::changed_frame(const std::vector<std::uint8_t>& shown) const {
  if (frames_.empty()) {
    return {0, 0, width_, height_, 0, shown};
  }
  const PixelBounds changed = changed_bounds(shown_, shown, width_);
  if (changed.bottom < 0) {
    return {0, 0, 1, 1, 0, {kUnchanged}};
  }
  GifFrame frame{changed.left,
                 changed.top,
                 changed.right - changed.left + 1,
                 changed.bottom - changed.top + 1,
                 0,
                 {}};
  frame.indices.reserve(static_cast<std::size_t>(frame.width_px) *
                        static_cast<std::size_t>(frame.height_px));
  for (int y = changed.top; y <= changed.bottom; ++y) {
    for (int x = changed.left; x <= changed.right; ++x) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(x);
      frame.indices.push_back(shown[pixel] == shown_[pixel] ? kUnchanged : shown[pixel]);
    }
  }
  return frame;
}

void GifAnimation::add(const Picture& picture, int duration_ms) {
  if (frames_.empty()) {
    if (std::max(picture.width(), picture.height()) > kMaxSidePx) {
      throw std::invalid_argument("gif animation: a side of the picture is above 65535 pixels");
    }
    width_ = picture.width();
    height_ = picture.height();
  } else if (picture.width() != width_ || picture.height() != height_) {
    throw std::invalid_argument("gif animation: the picture has another size than the first");
  }
  std::vector<std::uint8_t> shown = indices_of(picture);
  frames_.push_back(changed_frame(shown));
  frames_.back().duration_cs = std::clamp(duration_ms / 10, kMinDurationCs, kMaxDurationCs);
  shown_ = std::move(shown);
}

void GifAnimation::save(const std::filesystem::path& path) const {
  if (frames_.empty()) {
    throw files::FileError("cannot make " + path.string() + ": there is no picture to show");
  }
  std::string bytes;
  try {
    GifStream stream(width_, height_, palette_);
    stream.repeat_for_ever();
    for (const GifFrame& frame : frames_) {
      stream.write(frame);
    }
    bytes = stream.finish();
  } catch (const std::runtime_error& error) {
    throw files::FileError("cannot make " + path.string() + ": " + error.what());
  }
  files::write_text_file(path, bytes);
}

}  // namespace echomap::exports
