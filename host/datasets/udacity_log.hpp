// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads the log of the robot with eight sonars of the Udacity exercise: `measurement.txt`, a time
/// in milliseconds and ranges in millimetres at -90, -37.5, -22.5, -7.5, 7.5, 22.5, 37.5 and 90
/// degrees, and beside it `poses.txt`, `t x y theta` in milliseconds, millimetres and tenths of a
/// degree, with the same times. A line is a GivenPose and a RangeScan with cones of 20 degrees (the
/// beta of the exercise); 5110 is no return. Throws files::FileError.
std::unique_ptr<LogReader> open_udacity_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
