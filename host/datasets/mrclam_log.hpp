// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// Reads one robot of a UTIAS MRCLAM data set: `RobotN_Odometry.dat` (`t v w`), beside it
/// `RobotN_Measurement.dat` (`t barcode range bearing`), `Barcodes.dat` (`subject barcode`) and,
/// where it is there, `RobotN_Groundtruth.dat` (`t x y theta`); seconds, metres, radians. In the
/// order of their stamps come OdometrySteps (a speed holds until the next one), LandmarkSightings
/// by the number of the subject (1 to 5 are robots; a barcode that no subject has was misread and
/// is left out) and GivenPoses. Throws files::FileError.
std::unique_ptr<LogReader> open_mrclam_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
