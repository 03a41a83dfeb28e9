// SPDX-License-Identifier: MIT
#include "host/terminal_view/terminal_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

namespace echomap::terminal_view {
namespace {

bool has_utf8_locale(const ReadVariable& variable) {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string locale = variable(name);
    if (locale.empty()) {
      continue;
    }
    std::transform(locale.begin(), locale.end(), locale.begin(), [](unsigned char letter) {
      return static_cast<char>(std::tolower(letter));
    });
    return locale.find("utf-8") != std::string::npos || locale.find("utf8") != std::string::npos;
  }
  return false;
}

bool has_colours(const std::string& term) {
  static constexpr std::array kColourless{"vt52", "vt100", "vt102", "vt220", "vt320"};
  return std::find(kColourless.begin(), kColourless.end(), term) == kColourless.end();
}

}  // namespace

TerminalKind terminal_kind(const ReadVariable& variable) {
  const std::string term = variable("TERM");
  TerminalKind kind;
  kind.moves_cursor = !term.empty() && term != "dumb";
  if (kind.moves_cursor && has_colours(term) && variable("NO_COLOR").empty() &&
      has_utf8_locale(variable)) {
    kind.glyphs = Glyphs::kHalfBlocks;
  }
  return kind;
}

TerminalKind terminal_kind() {
  return terminal_kind([](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value != nullptr ? value : "");
  });
}

}  // namespace echomap::terminal_view
