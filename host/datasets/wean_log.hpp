// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads a log of Wean Hall (CMU, course 16-831): `O x y theta t`, an OdometryPose, and
/// `L x y theta xl yl thetal r1 .. r180 t`, an OdometryPose and a RangeScan of 180 beams from right
/// to left, one a degree, taken from where the laser is; centimetres, radians, seconds. No return
/// is 8183 or 8191: 81.8 m and more. Throws files::FileError.
std::unique_ptr<LogReader> open_wean_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
