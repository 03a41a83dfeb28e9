// SPDX-License-Identifier: MIT
#include "host/exports/picture.hpp"

#include <algorithm>
#include <cmath>
#include <png.h>

#include "host/exports/picture_font.hpp"
#include "host/exports/png_text.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/segment.hpp"

namespace echomap::exports {

namespace {

static_assert(sizeof(Colour) == 3, "a row of colours is a row of PNG's RGB");

constexpr int kGlyphAdvance = kGlyphWidth + 1;

void draw_glyph(Picture& picture, int x, int y, const Glyph& glyph, int scale, Colour colour) {
  for (int row = 0; row < kGlyphHeight; ++row) {
    for (int column = 0; column < kGlyphWidth; ++column) {
      if (glyph[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#') {
        picture.fill_rectangle(x + column * scale, y + row * scale, scale, scale, colour);
      }
    }
  }
}

}  // namespace

Picture::Picture(int width, int height, Colour background)
    : width_(width),
      height_(height),
      end_row_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

Colour Picture::at(int x, int y) const {
  return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
}

void Picture::limit_rows(int top, int bottom) {
  first_row_ = std::max(top, 0);
  end_row_ = std::min(bottom, height_);
}

void Picture::set(int x, int y, Colour colour) {
  if (x >= 0 && x < width_ && y >= first_row_ && y < end_row_) {
    pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)] = colour;
  }
}

void Picture::blend(int x, int y, Colour colour, double share) {
  if (x < 0 || x >= width_ || y < 0 || y >= height_) {
    return;
  }
  const auto mixed = [&](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround((1.0 - share) * below + share * above));
  };
  const Colour below = at(x, y);
  set(x,
      y,
      {mixed(below.red, colour.red),
       mixed(below.green, colour.green),
       mixed(below.blue, colour.blue)});
}

void Picture::fill_rectangle(int x, int y, int width, int height, Colour colour) {
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) {
      set(column, row, colour);
    }
  }
}

void Picture::fill_disc(const Eigen::Vector2d& centre, double radius, Colour colour) {
  draw_line(centre, centre, 2.0 * radius, colour);
}

void Picture::draw_circle(const Eigen::Vector2d& centre,
                          double radius,
                          double width,
                          Colour colour) {
  const double reach = radius + 0.5 * width;
  for (int y = static_cast<int>(std::floor(centre.y() - reach)); y <= centre.y() + reach; ++y) {
    for (int x = static_cast<int>(std::floor(centre.x() - reach)); x <= centre.x() + reach; ++x) {
      const double distance = (Eigen::Vector2d(x + 0.5, y + 0.5) - centre).norm();
      if (std::abs(distance - radius) <= 0.5 * width) {
        set(x, y, colour);
      }
    }
  }
}

void Picture::draw_line(const Eigen::Vector2d& from,
                        const Eigen::Vector2d& to,
                        double width,
                        Colour colour) {
  const geometry::Segment line{from, to};
  const double reach = 0.5 * width;
  const Eigen::Vector2d low = from.cwiseMin(to).array() - reach;
  const Eigen::Vector2d high = from.cwiseMax(to).array() + reach;
  for (int y = static_cast<int>(std::floor(low.y())); y <= high.y(); ++y) {
    for (int x = static_cast<int>(std::floor(low.x())); x <= high.x(); ++x) {
      if (geometry::distance_m(line, {x + 0.5, y + 0.5}) <= reach) {
        set(x, y, colour);
      }
    }
  }
}

int Picture::text_width(std::string_view text, int scale) {
  return static_cast<int>(text.size()) * kGlyphAdvance * scale;
}

void Picture::draw_text(int x, int y, std::string_view text, int scale, Colour colour) {
  for (const char letter : text) {
    if (const Glyph* glyph = glyph_of(letter)) {
      draw_glyph(*this, x, y, *glyph, scale, colour);
    }
    x += kGlyphAdvance * scale;
  }
}

void Picture::write_png(const std::filesystem::path& path,
                        const std::vector<PngText>& texts) const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<unsigned char> bytes(size);
  const int written =
      png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels_.data(), 0, nullptr);
  if (written == 0) {
    throw files::FileError("cannot make " + path.string() + ": " + image.message);
  }
  bytes.resize(size);
  add_png_texts(bytes, texts);
  files::AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace echomap::exports
