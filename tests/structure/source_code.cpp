// SPDX-License-Identifier: MIT
#include "tests/structure/source_code.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace echomap::structure {
namespace {

/// Where what begins at `from` ends: behind the next `end`.
std::size_t behind(const std::string& text, const std::string& end, std::size_t from) {
  const std::size_t at = text.find(end, from);
  return at == std::string::npos ? text.size() : at + end.size();
}

/// Behind a string or character literal, or a preprocessor line, in which \ takes the next
/// character's meaning.
std::size_t behind_unescaped(const std::string& text, char end, std::size_t from) {
  std::size_t at = from;
  while (at < text.size() && text[at] != end) {
    at += text[at] == '\\' ? 2 : 1;
  }
  return std::min(at + 1, text.size());
}

/// Where the comment, literal or preprocessor line that begins at `at` ends; `at` where none does.
std::size_t end_of_no_code(const std::string& text, std::size_t at) {
  const bool after_word = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
  if (text.compare(at, 2, "//") == 0) {
    return text.find('\n', at);
  }
  if (text.compare(at, 2, "/*") == 0) {
    return behind(text, "*/", at);
  }
  if (text.compare(at, 2, "R\"") == 0 && !after_word) {
    const std::size_t open = text.find('(', at);
    return behind(text, ")" + text.substr(at + 2, open - at - 2) + "\"", open);
  }
  if (text[at] == '#') {
    return behind_unescaped(text, '\n', at) - 1;
  }
  const bool is_literal = text[at] == '"' || (text[at] == '\'' && !after_word);
  return is_literal ? behind_unescaped(text, text[at], at + 1) : at;
}

}  // namespace

std::string code_of(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) {
    text += line + '\n';
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_no_code(text, at);
    for (std::size_t i = at; i < end; ++i) {
      text[i] = text[i] == '\n' ? '\n' : ' ';
    }
    at = std::max(at + 1, end);
  }
  return text;
}

}  // namespace echomap::structure
