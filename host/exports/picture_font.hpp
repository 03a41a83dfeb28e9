// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace echomap::exports {

/// Size of every letter, in pixels.
constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 7;

/// A letter, row by row from the top: # is ink.
using Glyph = std::array<std::string_view, kGlyphHeight>;

/// Digits, small letters and the marks . , - : % / _; null for anything else, as for a blank.
const Glyph* glyph_of(char letter);

}  // namespace echomap::exports
