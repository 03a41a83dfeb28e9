// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads the wall-following readings of a SCITOS G5 (UCI repository): a line holds the 24 ranges of
/// its sonar ring in metres, CLOCKWISE from the front in steps of 15 degrees, and the label of what
/// the robot did. A line is a RangeScan with cones of 15 degrees, so that the ring closes; 5 m and
/// more is no return. There are no stamps (the readings are 9 a second) and no odometry. Throws
/// files::FileError.
std::unique_ptr<LogReader> open_uci_ring_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
