// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of the Mines ParisTech rover as BreezySLAM has it: 24 fields of which the first is
/// the time in microseconds and the third and fourth are the ticks of the left and right wheel
/// (2000 a turn, radius 77 mm, track 330 mm), then 683 ranges of a Hokuyo URG-04LX in millimetres,
/// 145 mm ahead, counter-clockwise in steps of 360/1024 degrees; the outer 70 on either side see
/// the robot and are left out. Zero, the error codes below 20, and 5.6 m (the end of its scale) are
/// no return. A line is a WheelIncrement and a RangeScan. Throws files::FileError.
std::unique_ptr<LogReader> open_breezyslam_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
