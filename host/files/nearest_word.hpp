// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace echomap::files {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment distance).
std::size_t edit_distance(std::string_view from, std::string_view to);

/// `; did you mean 'x'?` with the valid word nearest to `word`, or, where none is near, a list of
/// the valid words; empty where there are none.
std::string suggestion(std::string_view word, const std::vector<std::string>& valid);

}  // namespace echomap::files
