// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// The text of a file with every comment, literal and preprocessor line as blanks, its line breaks
/// kept: what is left of braces and semicolons is code.
std::string code_of(const SourceFile& file);

}  // namespace echomap::structure
