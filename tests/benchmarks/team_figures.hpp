// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/team_runs.hpp"

namespace echomap::bench {

/// One row for each team and, where it was made, its single robot: what failed is in it, too.
MarkdownTable team_table(const std::vector<TeamPair>& pairs);

/// What all of them come to. A place counts as merged where all teams that were started there with
/// one seed were; a team that never had nine tenths of the floor took for ever.
std::vector<Figure> team_figures(const std::vector<TeamPair>& pairs);

}  // namespace echomap::bench
