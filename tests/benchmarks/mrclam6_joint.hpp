// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "host/evaluation/team_comparison.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// The robots of a folder of UTIAS MRCLAM by odometry, each alone and jointly; sightings of
/// landmarks by the robots of `blind` are left out. Throws files::FileError.
evaluation::TeamScore localize_mrclam(const std::filesystem::path& folder,
                                      const std::set<std::int64_t>& blind = {});

/// By how much the RMSE of set 6 is lower jointly than alone, of the robot that gains least and of
/// all five together; none where the set is not there.
std::vector<Figure> mrclam6_joint_figures(bool verbose);

/// The first of them: mrclam6_joint_gain_percent; empty where the set is not there.
std::optional<double> mrclam6_joint_gain_percent();

}  // namespace echomap::bench
