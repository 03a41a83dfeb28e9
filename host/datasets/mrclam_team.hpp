// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "host/datasets/log_record.hpp"

namespace echomap::datasets {

/// How the robots of UTIAS MRCLAM do what they are commanded, which is what their odometry files
/// hold, and when their sightings were made. Measured against the true paths of set 7.
struct MrclamTiming {
  double command_lag_s = 0.2;   ///< A command takes effect that much later.
  double picture_age_s = 0.05;  ///< A sighting is stamped that long after the picture.
  double drive_share = 0.90;    ///< Of the commanded distance.
  double turn_share = 0.93;     ///< Of the commanded turn.
};

/// What one robot of a team has moved, seen, or where it truly was.
struct TeamRecord {
  double stamp_s = 0.0;
  std::int64_t robot = 0;
  std::variant<OdometryStep, LandmarkSighting, GivenPose> record;
};

/// Logs of several robots in one room, on one clock.
struct TeamLog {
  std::vector<std::int64_t> robots;                     ///< Their numbers, rising.
  std::map<std::int64_t, Eigen::Vector2d> landmarks_m;  ///< As surveyed, by their numbers.
  std::vector<TeamRecord> records;                      ///< In the order of their stamps.
  std::vector<std::string> notes;                       ///< What of the logs is not used.
};

/// Reads all robots of a folder of UTIAS MRCLAM: `RobotN_Odometry.dat` and what goes with each (see
/// open_mrclam_log), and `Landmark_Groundtruth.dat` (`subject x y x-stddev y-stddev`); plain or gz.
/// Throws files::FileError: where the folder has not at least two robots, where a file is missing,
/// and with `file:line: ` where one is not what its format says.
TeamLog read_mrclam_team(const std::filesystem::path& folder, const MrclamTiming& timing = {});

}  // namespace echomap::datasets
