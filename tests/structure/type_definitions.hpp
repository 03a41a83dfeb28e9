// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// One struct, class, union or enumeration with a body, at namespace scope; `name` has its
/// namespaces, `line` counts from 1.
struct TypeDefinition {
  std::string name;
  std::string path;
  int line = 0;
};

/// The types that `file` defines for the whole program: not those within another type or a
/// function, in an anonymous namespace or a macro, and no specialisation of a template.
std::vector<TypeDefinition> type_definitions_in(const SourceFile& file);

/// Every type with more than one definition in `files`, as "name: path:line, path:line". One
/// program that links two of them breaks the one definition rule, and no compiler says so.
std::vector<std::string> types_defined_twice(const std::vector<SourceFile>& files);

}  // namespace echomap::structure
