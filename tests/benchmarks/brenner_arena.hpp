// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"
#include "host/models/odometry_motion.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

/// A scan of Brenner's log has taken that long when it is stamped.
inline constexpr double kBrennerScanAgeS = 0.1;
/// His scanner reads short by that: bearings alone place the robot where ranges are so much longer.
inline constexpr double kBrennerReadsShortM = 0.085;

/// What is known of his arena and robot beside the log itself.
struct BrennerArena {
  std::vector<Eigen::Vector2d> landmarks_m;  ///< Cylinders.
  geometry::Pose2 T_map_start;               ///< The robot at the log's first scan.
  Eigen::Matrix3d start_covariance;          ///< Of that, in m and rad.
  geometry::Pose2 T_robot_scanner;
  models::OdometryMotionParams motion;
  std::vector<datasets::LogRecord> records;
};

/// Throws files::FileError.
BrennerArena read_brenner(const std::filesystem::path& folder);

/// Where the camera overhead saw the scanner; with `scaled` made smaller around its middle: the
/// scanner stands nearer to the camera than the floor.
TruePath brenner_reference(const BrennerArena& arena, bool scaled);

/// How the robot moved, by its wheels.
geometry::Pose2 brenner_step(const datasets::WheelIncrement& wheels);

}  // namespace echomap::bench
