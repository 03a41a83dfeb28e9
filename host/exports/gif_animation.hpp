// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include "host/exports/picture.hpp"

namespace echomap::exports {

/// What of a picture of an animation differs from the one before.
struct GifFrame {
  int left_px = 0;
  int top_px = 0;
  int width_px = 1;
  int height_px = 1;
  int duration_cs = 0;  ///< Hundredths of a second.
  /// Of the animation's palette, row by row from the top; 255 is a pixel that stays as it is.
  std::vector<std::uint8_t> indices;
};

/// Pictures of one size, shown one after the other for ever, as a GIF file (GIF89a with the
/// extension NETSCAPE2.0 for the repetition). A frame stores the smallest rectangle that holds all
/// pixels that differ from the frame before, and there only those. The file has up to 255 colours;
/// `exact` are kept as they are, and so are the first others. A colour beyond them is shown as the
/// nearest of these.
class GifAnimation {
 public:
  /// Throws std::invalid_argument for more than 255 exact colours.
  explicit GifAnimation(const std::vector<Colour>& exact = {});

  /// Appends a picture that is shown for that time, which is rounded down to hundredths of a second
  /// and at least two of them: viewers show shorter ones for longer. Throws std::invalid_argument
  /// for a picture of another size than the first, or larger than a GIF can be (65535 pixels).
  void add(const Picture& picture, int duration_ms);

  /// The same pictures make the same bytes. Throws files::FileError, also where there is no
  /// picture.
  void save(const std::filesystem::path& path) const;

 private:
  using ColourKey = std::array<std::uint8_t, 3>;

  std::uint8_t index_of(Colour colour);
  std::uint8_t nearest_index(Colour colour) const;
  std::vector<std::uint8_t> indices_of(const Picture& picture);
  /// The rectangle of what differs from the last picture; the whole of the first.
  GifFrame changed_frame(const std::vector<std::uint8_t>& shown) const;

  int width_ = 0;
  int height_ = 0;
  std::vector<Colour> palette_;
  std::map<ColourKey, std::uint8_t> known_;
  std::vector<std::uint8_t> shown_;  ///< Indices of the last picture, row by row.
  std::vector<GifFrame> frames_;
};

}  // namespace echomap::exports
