// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace echomap::bench {

/// The variables of a MATLAB 5 file that is not packed, as columns of numbers. Those of other kinds
/// than real matrices are left out. Throws files::FileError.
std::map<std::string, std::vector<double>> read_mat_file(const std::filesystem::path& path);

}  // namespace echomap::bench
