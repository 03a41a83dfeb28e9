// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// A function with a body; `line` is where it begins, counted from 1, `lines` runs from there to
/// its closing brace.
struct FunctionLength {
  std::string path;
  int line = 0;
  int lines = 0;
};

/// The functions that `file` defines, members among them; those within functions count as part of
/// these.
std::vector<FunctionLength> functions_in(const SourceFile& file);

}  // namespace echomap::structure
