// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/exports/picture.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::paper_report {

/// A PNG file of one colour.
inline std::vector<std::uint8_t> tiny_png(int width_px, int height_px) {
  const tests::ScratchFolder folder;
  exports::Picture(width_px, height_px, {200, 30, 10}).write_png(folder / "tiny.png");
  const std::string bytes = files::read_text_file(folder / "tiny.png");
  return {bytes.begin(), bytes.end()};
}

}  // namespace echomap::paper_report
