// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace echomap::bench {

/// A table as docs hold it.
struct MarkdownTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// The table's lines, a `|` within a cell escaped. Throws std::invalid_argument for a row with
/// more or fewer cells than the header.
std::string to_markdown(const MarkdownTable& table);

}  // namespace echomap::bench
