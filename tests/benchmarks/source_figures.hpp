// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// source_time_ratio, sharing_saving_percent, none_right_percent and claims_right_percent, over all
/// worlds and by world, as the benchmark of the search of a source measures them for so many seeds;
/// `program` is that benchmark, empty for the one beside this program. Throws std::runtime_error
/// where it does not end well.
std::vector<Figure> source_figures(std::uint32_t seeds, const std::filesystem::path& program = {});

}  // namespace echomap::bench
