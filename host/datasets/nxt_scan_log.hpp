// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads one scan of a LEGO NXT that turned its sonar once round: a range in centimetres a line, at
/// even steps of the full turn (72 of 5 degrees, 36 of 10), from straight ahead on and, as far as
/// is known, counter-clockwise; 255 is no return. The log is one RangeScan with cones of 30
/// degrees, and no pose: the robot stood. At most 3600 ranges. Throws files::FileError.
std::unique_ptr<LogReader> open_nxt_scan_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
