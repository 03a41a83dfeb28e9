// SPDX-License-Identifier: MIT
#include "host/terminal_view/terminal_kind.hpp"

#include <map>

#include <gtest/gtest.h>

namespace echomap::terminal_view {
namespace {

TerminalKind kind_in(std::map<std::string, std::string> variables) {
  return terminal_kind([&](const char* name) { return variables[name]; });
}

constexpr TerminalKind kColoured{Glyphs::kHalfBlocks, true};
constexpr TerminalKind kAscii{Glyphs::kAscii, true};
constexpr TerminalKind kDumb{Glyphs::kAscii, false};

TEST(TerminalKind, HasHalfBlocksWhereColoursAndUtf8Are) {
  EXPECT_EQ(kind_in({{"TERM", "xterm-256color"}, {"LANG", "en_GB.UTF-8"}}), kColoured);
  EXPECT_EQ(kind_in({{"TERM", "screen"}, {"LC_CTYPE", "C.utf8"}, {"LANG", "C"}}), kColoured);
}

TEST(TerminalKind, HasAsciiWithoutAUtf8Locale) {
  EXPECT_EQ(kind_in({{"TERM", "xterm"}}), kAscii);
  EXPECT_EQ(kind_in({{"TERM", "xterm"}, {"LC_ALL", "C"}, {"LANG", "en_GB.UTF-8"}}), kAscii);
  EXPECT_EQ(kind_in({{"TERM", "xterm"}, {"LANG", "de_DE.ISO-8859-1"}}), kAscii);
}

TEST(TerminalKind, HasAsciiWithoutColours) {
  EXPECT_EQ(kind_in({{"TERM", "xterm"}, {"LANG", "C.UTF-8"}, {"NO_COLOR", "1"}}), kAscii);
  EXPECT_EQ(kind_in({{"TERM", "vt100"}, {"LANG", "C.UTF-8"}}), kAscii);
}

TEST(TerminalKind, MovesNoCursorOnADumbTerminal) {
  EXPECT_EQ(kind_in({{"TERM", "dumb"}, {"LANG", "C.UTF-8"}}), kDumb);
  EXPECT_EQ(kind_in({{"LANG", "C.UTF-8"}}), kDumb);
}

}  // namespace
}  // namespace echomap::terminal_view
