// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of the Big Wheel Bot: `left, right, yaw, front, rear, left IR, right IR, servo,
/// servo` a line, some 0.3 s apart and without stamps. Ticks of 5 mm since the line before; yaw in
/// degrees CLOCKWISE, here turned round; ranges in centimetres, 500 and more of a sonar and 60 and
/// more of an infra-red sensor is no return. A line is a Heading, a WheelIncrement (its track, 0.19
/// m, is a mean: the robot skids), a RangeScan of the two sonars (cones of 30 degrees, ahead and
/// behind) and one of the two infra-red sensors (45 degrees to either side). Throws
/// files::FileError.
std::unique_ptr<LogReader> open_big_wheel_bot_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
