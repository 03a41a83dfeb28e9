// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// Paths of the product's files that no program reaches, sorted. A program is a source with a main
/// function. It reaches what it includes, and with a header the sources that include this header
/// first: they define what it declares.
std::vector<std::string> files_in_no_program(const std::vector<SourceFile>& files);

}  // namespace echomap::structure
