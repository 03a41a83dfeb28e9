// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

/// The rules of docs/conventions.md that a machine can see. Each function returns what breaks its
/// rule, as "file:line: what" or "file: what".
namespace echomap::structure {

/// What breaks a rule; empty where all is well.
using Problems = std::vector<std::string>;

/// Every file begins with the SPDX line of its licence; a header's second line is #pragma once.
Problems first_line_problems(const std::vector<SourceFile>& files);

/// No file is longer than 500 lines.
Problems length_problems(const std::vector<SourceFile>& files);

/// Every x/y.cpp outside tests/ has a tests/x/y_test.cpp, unless it is or lies below one of
/// `exceptions`.
Problems untested_source_problems(const std::vector<SourceFile>& files,
                                  const std::vector<std::string>& exceptions);

/// No folder is named util, utils, common, core, helpers or misc.
Problems folder_name_problems(const std::vector<SourceFile>& files);

/// protocol/ and the portable firmware use C headers only and nothing of namespace std.
Problems portability_problems(const std::vector<SourceFile>& files);

/// Every paragraph of declarations in a header outside tests/ begins with a `///` comment. A
/// heuristic: it looks at lines without indentation that follow an empty line or open a namespace's
/// body.
Problems undocumented_problems(const std::vector<SourceFile>& files);

/// No line reminds of work left to do.
Problems reminder_problems(const std::vector<SourceFile>& files);

}  // namespace echomap::structure
