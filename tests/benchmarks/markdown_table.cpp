// SPDX-License-Identifier: MIT
#include "tests/benchmarks/markdown_table.hpp"

#include <stdexcept>

namespace echomap::bench {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char letter : cell) {
      line += letter == '|' ? "\\|" : std::string(1, letter);
    }
    line += " |";
  }
  return line + '\n';
}

}  // namespace

std::string to_markdown(const MarkdownTable& table) {
  std::string text = line_of(table.header) + "|";
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    text += "---|";
  }
  text += '\n';
  for (const auto& row : table.rows) {
    if (row.size() != table.header.size()) {
      throw std::invalid_argument("markdown table: a row has other cells than the header");
    }
    text += line_of(row);
  }
  return text;
}

}  // namespace echomap::bench
