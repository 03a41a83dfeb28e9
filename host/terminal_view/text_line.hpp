// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/terminal_view/terminal_kind.hpp"

namespace echomap::terminal_view {

/// How many columns a line of UTF-8 takes on a terminal; colour sequences take none. Its characters
/// must be as narrow as those of `printable`.
int columns_of(std::string_view line);

/// A text without what would move the cursor or be wider than a column: such characters become '?'.
/// In ASCII "m²", "±" and "°" become "m2", "+-" and " deg".
std::string printable(std::string_view text, Glyphs glyphs);

/// Breaks a printable text at spaces into lines of so many columns at most; a word that is longer
/// is cut. None for an empty text.
std::vector<std::string> wrapped(std::string_view text, int columns);

/// Joins facts, of which some may be coloured, into lines of so many columns at most, two spaces
/// between them; a fact that is longer is wrapped over lines of its own.
std::vector<std::string> flowed(const std::vector<std::string>& facts, int columns);

}  // namespace echomap::terminal_view
