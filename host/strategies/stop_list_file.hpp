// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/exploration/stop_tour.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::strategies {

/// Reads a list of stops: [[place]] with x_m and y_m in the map frame, in the order of the tour,
/// and where wanted a name and `sweep = false` for a place that is only passed. Throws
/// files::ConfigError.
std::vector<exploration::TourPlace> read_stop_list(const files::TomlReader& file);

/// Throws files::ConfigError.
std::vector<exploration::TourPlace> load_stop_list(const std::filesystem::path& path);

}  // namespace echomap::strategies
