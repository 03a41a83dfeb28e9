// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace echomap::exports {

/// A grey picture, rows from the top.
struct PgmImage {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> pixels;
};

/// Writes binary PGM (P5, 255 levels). Throws files::FileError.
void write_pgm(const std::filesystem::path& path, const PgmImage& image);

/// Reads the same, comments in the header included. Throws files::FileError that begins with the
/// file's name where the header is wrong or pixels are missing.
PgmImage read_pgm(const std::filesystem::path& path);

}  // namespace echomap::exports
