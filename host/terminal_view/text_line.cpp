// SPDX-License-Identifier: MIT
#include "host/terminal_view/text_line.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace echomap::terminal_view {
namespace {

bool continues_a_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Bytes of the character that begins there.
std::size_t bytes_of_character(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && continues_a_character(text[end])) {
    ++end;
  }
  return end - at;
}

/// Bytes of an escape sequence ESC [ ... letter that begins there; 0 where none does.
std::size_t bytes_of_escape(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) != "\033[") {
    return 0;
  }
  std::size_t end = at + 2;
  while (end < text.size() && (text[end] < '@' || text[end] > '~')) {
    ++end;
  }
  return std::min(end + 1, text.size()) - at;
}

std::string ascii_of(std::string_view character) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kSpelt{
      {{"²", "2"}, {"±", "+-"}, {"°", " deg"}}};
  const auto found = std::find_if(kSpelt.begin(), kSpelt.end(), [character](const auto& spelt) {
    return spelt.first == character;
  });
  return std::string(found != kSpelt.end() ? found->second : "?");
}

/// Latin letters and signs up to U+02FF, which are one column wide everywhere.
bool is_narrow(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  const auto second = character.size() > 1 ? static_cast<unsigned char>(character[1]) : 0U;
  return character.size() == 2 && first >= 0xC2U && first <= 0xCBU &&
         (first != 0xC2U || (second >= 0xA1U && second != 0xADU));
}

/// The bytes of the first so many columns of a text without escape sequences.
std::size_t bytes_of_columns(std::string_view text, int columns) {
  std::size_t at = 0;
  for (int column = 0; column < columns && at < text.size(); ++column) {
    at += bytes_of_character(text, at);
  }
  return at;
}

}  // namespace

int columns_of(std::string_view line) {
  int columns = 0;
  for (std::size_t at = 0; at < line.size();) {
    if (const std::size_t escape = bytes_of_escape(line, at); escape > 0) {
      at += escape;
      continue;
    }
    ++columns;
    at += bytes_of_character(line, at);
  }
  return columns;
}

std::string printable(std::string_view text, Glyphs glyphs) {
  std::string printed;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view character = text.substr(at, bytes_of_character(text, at));
    at += character.size();
    if (character.size() == 1) {
      const char letter = character.front();
      printed += letter >= ' ' && letter <= '~' ? letter : '?';
    } else if (glyphs == Glyphs::kAscii) {
      printed += ascii_of(character);
    } else {
      printed += is_narrow(character) ? character : "?";
    }
  }
  return printed;
}

std::vector<std::string> wrapped(std::string_view text, int columns) {
  std::vector<std::string> lines;
  if (columns < 1) {
    return lines;
  }
  while (!text.empty()) {
    std::size_t end = bytes_of_columns(text, columns);
    std::size_t next = end;
    if (end < text.size()) {
      const std::size_t space = text.substr(0, end + 1).rfind(' ');
      if (space != std::string_view::npos && space > 0) {
        end = space;
        next = space + 1;
      }
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(next);
  }
  return lines;
}

std::vector<std::string> flowed(const std::vector<std::string>& facts, int columns) {
  std::vector<std::string> lines;
  int used = columns;
  for (const std::string& fact : facts) {
    const int needed = columns_of(fact);
    if (used + 2 + needed <= columns) {
      lines.back() += "  " + fact;
      used += 2 + needed;
      continue;
    }
    const auto parts = needed <= columns ? std::vector<std::string>{fact} : wrapped(fact, columns);
    lines.insert(lines.end(), parts.begin(), parts.end());
    used = parts.empty() ? columns : columns_of(parts.back());
  }
  return lines;
}

}  // namespace echomap::terminal_view
