// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace echomap::exports {

/// What a PNG file says beside its picture: a tEXt chunk. The key has 1 to 79 letters.
struct PngText {
  std::string key;
  std::string text;

  bool operator==(const PngText&) const = default;
};

/// Puts tEXt chunks behind the header of a whole PNG file in memory.
void add_png_texts(std::vector<unsigned char>& png, const std::vector<PngText>& texts);

}  // namespace echomap::exports
