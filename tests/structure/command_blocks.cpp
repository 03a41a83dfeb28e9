// SPDX-License-Identifier: MIT
#include "tests/structure/command_blocks.hpp"

#include <stdexcept>

namespace echomap::structure {

std::vector<CommandBlock> command_blocks_of(const std::vector<std::string>& lines) {
  std::vector<CommandBlock> blocks;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != "<!-- test -->") {
      continue;
    }
    CommandBlock block{i + 1, ""};
    if (++i == lines.size() || lines[i] != "```sh") {
      throw std::runtime_error("no ```sh after the mark in line " + std::to_string(block.line));
    }
    for (++i; i < lines.size() && lines[i] != "```"; ++i) {
      block.script += lines[i] + "\n";
    }
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace echomap::structure
