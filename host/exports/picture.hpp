// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "host/exports/png_text.hpp"

namespace echomap::exports {

/// A colour, 8 bits a channel.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Colour&) const = default;
};

/// A colour picture to draw on. Places are pixels from the upper left corner, x right, y down; what
/// falls outside is cut off.
class Picture {
 public:
  Picture(int width, int height, Colour background);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The place must be inside.
  Colour at(int x, int y) const;

  /// From now on nothing is drawn above row `top` nor from row `bottom` on.
  void limit_rows(int top, int bottom);
  void set(int x, int y, Colour colour);
  void fill_rectangle(int x, int y, int width, int height, Colour colour);
  void fill_disc(const Eigen::Vector2d& centre, double radius, Colour colour);
  /// Mixes one pixel's colour with `colour`, of which `share` is taken, 0 to 1.
  void blend(int x, int y, Colour colour, double share);
  /// A ring, `width` pixels wide, its middle `radius` from the centre.
  void draw_circle(const Eigen::Vector2d& centre, double radius, double width, Colour colour);
  /// A line with round ends, `width` pixels wide.
  void draw_line(const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to,
                 double width,
                 Colour colour);
  /// The letters of picture_font.hpp, each 5 x 7 pixels times `scale`, one pixel times `scale`
  /// apart; (x, y) is the upper left corner. Other letters leave a blank.
  void draw_text(int x, int y, std::string_view text, int scale, Colour colour);

  /// How far draw_text goes on.
  static int text_width(std::string_view text, int scale);

  /// Throws files::FileError.
  void write_png(const std::filesystem::path& path, const std::vector<PngText>& texts = {}) const;

 private:
  int width_;
  int height_;
  int first_row_ = 0;
  int end_row_;
  std::vector<Colour> pixels_;
};

}  // namespace echomap::exports
