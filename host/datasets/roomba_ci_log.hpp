// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of the Roombas of RoombaCI (Clemson), comma separated, of one of two kinds: with a
/// header and 13 columns (2018: time, distance, .., encoders, .., bumper byte, light bumper byte),
/// or with 12 and a semicolon at the end (2021: time, encoders, heading, bumper byte, ..). Encoders
/// are 16-bit counters that WRAP (508.8 a turn of a wheel of 72 mm, track 235 mm); the heading of
/// 2021 is in degrees CLOCKWISE, here turned round; bytes are eight binary digits, bumper right (1)
/// and left (2). A line is a WheelIncrement and a Contact, in 2021 a Heading before them. Throws
/// files::FileError.
std::unique_ptr<LogReader> open_roomba_ci_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
