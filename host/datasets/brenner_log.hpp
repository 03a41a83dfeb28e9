// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of Claus Brenner's LEGO robot (Hannover): `NAME_scan.txt` (`S t n r1 .. rn`), beside
/// it `NAME_motors.txt` (`M t left . . . right ..`) and, where it is there, `NAME_reference.txt`
/// (`P t x y`); milliseconds and millimetres. In the order of their stamps come WheelIncrements
/// (0.349 mm a tick, track 155 mm), RangeScans (30 mm ahead, beam i at (i - 330) * 0.006135923 -
/// 0.0698132 rad, 4 m and more is no return) and GivenPositions: the camera saw no heading. Throws
/// files::FileError.
std::unique_ptr<LogReader> open_brenner_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
