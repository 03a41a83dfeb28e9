// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads the text form of the Edmonton log (Roy, 2002, as MRPT gives it): `NAME_LASER.txt`, 180
/// ranges a line in metres from -90 degrees on in steps of one, and beside it `NAME_ODO.txt`, an
/// increment `dx dy dphi` a line. The scan of a line was taken BEFORE the increment of the same
/// line: an OdometryStep stands after its RangeScan and has the stamp of the next one, where it
/// leads to; the last one leads to none and is left out. Where they are there,
/// `NAME_TIME_interp.txt` gives stamps (the rawlog has none of use) and `NAME_REF.txt` GivenPoses
/// for some of the scans. Ranges of 30 m and more are flagged invalid in the recording: no return.
/// Each file may be packed. Throws files::FileError.
std::unique_ptr<LogReader> open_edmonton_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
