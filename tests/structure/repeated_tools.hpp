// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// A function that is defined at namespace scope and knows nothing of the project: all parameters
/// are of built-in types or of the standard library's and Eigen's.
struct Tool {
  std::string signature;  ///< Name and types of the parameters, as in "square(double)".
  std::string path;
};

/// The tools that a file defines, as far as lines without indentation tell.
std::vector<Tool> tools_in(const SourceFile& file);

/// Every tool that stands in two of the files, as "signature: path, path".
std::vector<std::string> repeated_tools(const std::vector<SourceFile>& files);

/// Every line of `files` that factorises a least-squares problem outside of `solver_folder`, as
/// "path:line".
std::vector<std::string> second_solvers(const std::vector<SourceFile>& files,
                                        const std::string& solver_folder);

}  // namespace echomap::structure
