// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace echomap::structure {

/// A ```sh block of a document that stands below the line <!-- test -->.
struct CommandBlock {
  std::size_t line = 0;  ///< Of its mark, from 1.
  std::string script;
};

/// The marked blocks of a document. Throws std::runtime_error where a mark stands before anything
/// else.
std::vector<CommandBlock> command_blocks_of(const std::vector<std::string>& lines);

}  // namespace echomap::structure
