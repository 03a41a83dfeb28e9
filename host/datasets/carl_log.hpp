// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of Carl, a GoPiGo3 with a range sensor on a pan servo: a header, then
/// `YYYYMMDD-HHMMSS.mmm, left, right, heading, pan, range` a line. Encoders in degrees of the wheel
/// (64 mm, track 114.05 mm); heading of the gyro and pan in degrees CLOCKWISE, here turned round;
/// range in millimetres, 3000 is no return. A line is a Heading, a WheelIncrement and a RangeScan
/// of one beam with an opening of 25 degrees. Stamps are seconds since 1970, taken for UTC. Throws
/// files::FileError.
std::unique_ptr<LogReader> open_carl_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
