// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace echomap::terminal_view {

/// What a picture is drawn with: coloured half blocks, two pixels a character, or plain ASCII.
enum class Glyphs : std::uint8_t { kHalfBlocks, kAscii };

/// A number of characters across and down.
struct TextSize {
  int columns = 80;
  int lines = 24;
  bool operator==(const TextSize&) const = default;
};

/// What a terminal can do.
struct TerminalKind {
  Glyphs glyphs = Glyphs::kAscii;
  bool moves_cursor = false;  ///< Whether it obeys escape sequences.
  bool operator==(const TerminalKind&) const = default;
};

/// Value of an environment variable; empty where it is not set.
using ReadVariable = std::function<std::string(const char* name)>;

/// Judges a terminal by TERM, NO_COLOR (https://no-color.org) and the locale: LC_ALL, LC_CTYPE or
/// LANG, the first that is set.
TerminalKind terminal_kind(const ReadVariable& variable);
/// The same by the environment of this process.
TerminalKind terminal_kind();

}  // namespace echomap::terminal_view
