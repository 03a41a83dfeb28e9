// SPDX-License-Identifier: MIT
#include "host/exports/pgm_image.hpp"

#include <istream>
#include <limits>
#include <sstream>
#include <string>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr int kLargestSide = 65536;

/// The next whole number of a PGM header; -1 where there is none.
int next_header_number(std::istream& header) {
  while ((header >> std::ws).peek() == '#') {
    header.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  int number = -1;
  header >> number;
  return header ? number : -1;
}

}  // namespace

void write_pgm(const std::filesystem::path& path, const PgmImage& image) {
  std::string bytes =
      "P5\n" + std::to_string(image.columns) + " " + std::to_string(image.rows) + "\n255\n";
  bytes.append(image.pixels.begin(), image.pixels.end());
  files::write_text_file(path, bytes);
}

PgmImage read_pgm(const std::filesystem::path& path) {
  std::istringstream stream(files::read_text_file(path));
  std::string magic;
  stream >> magic;
  PgmImage image;
  image.columns = next_header_number(stream);
  image.rows = next_header_number(stream);
  const int levels = next_header_number(stream);
  const bool size_ok = image.columns > 0 && image.columns <= kLargestSide && image.rows > 0 &&
                       image.rows <= kLargestSide;
  if (magic != "P5" || !size_ok || levels != 255) {
    fail_at_line(path, 1, "expected a binary PGM header: P5, columns, rows, 255");
  }
  stream.get();
  const std::string pixels{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t expected =
      static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  if (pixels.size() < expected) {
    throw files::FileError(path.string() + ": expected " + std::to_string(expected) +
                           " pixels, found " + std::to_string(pixels.size()));
  }
  image.pixels.assign(pixels.begin(), pixels.begin() + static_cast<std::ptrdiff_t>(expected));
  return image;
}

}  // namespace echomap::exports
