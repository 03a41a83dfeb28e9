// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a trajectory in the TUM format: `t x y z qx qy qz qw` a line, seconds and metres; of the
/// rotation, the turn about z. Each line is a GivenPose. Lines that begin with # are skipped.
/// Throws files::FileError.
std::unique_ptr<LogReader> open_tum_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
