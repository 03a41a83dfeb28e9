// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>

#include "host/datasets/mrclam_team.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::tests {

/// Writes two robots of 60 seconds in the format of UTIAS MRCLAM. Both drive along x, one behind
/// the other. Robot 1 does what it is commanded and sees the landmark 6 all the time; robot 2, 2 m
/// ahead, drives a twentieth faster than that, sees no landmark and is seen by robot 1.
inline void write_team_folder(const std::filesystem::path& folder) {
  constexpr double kStartS = 1000.0;
  constexpr double kSpeedMPerS = 0.1;
  constexpr double kFaster = 1.05;
  constexpr double kAheadM = 2.0;
  constexpr double kLandmarkM = 12.0;
  const datasets::MrclamTiming timing;
  std::ostringstream odometry;
  std::ostringstream truth_1;
  std::ostringstream truth_2;
  std::ostringstream sightings;
  for (std::ostringstream* file : {&odometry, &truth_1, &truth_2, &sightings}) {
    *file << "# a comment\n" << std::fixed << std::setprecision(6);
  }
  const auto driven_m = [](double at_s) { return kSpeedMPerS * std::fmax(0.0, at_s - kStartS); };
  for (int i = 0; i <= 600; ++i) {
    const double stamp_s = kStartS + 0.1 * i;
    const double picture_s = stamp_s + 0.02;
    odometry << stamp_s - timing.command_lag_s << ' ' << kSpeedMPerS / timing.drive_share << " 0\n";
    truth_1 << stamp_s << ' ' << driven_m(stamp_s) << " 0 0\n";
    truth_2 << stamp_s << ' ' << kAheadM + kFaster * driven_m(stamp_s) << " 0 0\n";
    const double own_m = driven_m(picture_s);
    sightings << picture_s + timing.picture_age_s << " 72 " << kLandmarkM - own_m << " 0\n"
              << picture_s + timing.picture_age_s << " 14 " << kAheadM + kFaster * own_m - own_m
              << " 0\n";
  }
  files::write_text_file(folder / "Barcodes.dat", "1 5\n2 14\n6 72\n");
  files::write_text_file(folder / "Landmark_Groundtruth.dat",
                         "# s x y sx sy\n6 12 0 0.001 0.001\n");
  for (const std::string robot : {"Robot1", "Robot2"}) {
    const bool is_first = robot == "Robot1";
    files::write_text_file(folder / (robot + "_Odometry.dat"), odometry.str());
    files::write_text_file(folder / (robot + "_Groundtruth.dat"),
                           is_first ? truth_1.str() : truth_2.str());
    files::write_text_file(folder / (robot + "_Measurement.dat"),
                           is_first ? sightings.str() : "# none\n");
  }
}

}  // namespace echomap::tests
