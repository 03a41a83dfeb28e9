// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"
#include "host/slam/landmark_slam.hpp"

namespace echomap::papers {

/// All of these take a log of odometry increments and laser scans, and give one pose for each scan.
/// The log begins at the origin.

/// Poses of the scans by equations 1 to 3 of Akzhalova and Polichshuk.
std::vector<geometry::Pose2> paper_odometry(const std::vector<datasets::LogRecord>& records);

/// Poses of the scans by increments that are composed as they are.
std::vector<geometry::Pose2> composed_odometry(const std::vector<datasets::LogRecord>& records);

/// Runs EKF-SLAM over the log.
void run_landmark_slam(const std::vector<datasets::LogRecord>& records, slam::LandmarkSlam& method);

/// Points where beams ended within `max_range_m`, by equations 4 to 6 from these poses.
std::vector<Eigen::Vector2d> scanned_points_m(const std::vector<datasets::LogRecord>& records,
                                              const std::vector<geometry::Pose2>& T_map_scans,
                                              double max_range_m);

/// Length of the path through these poses, metres.
double path_length_m(const std::vector<geometry::Pose2>& path);

}  // namespace echomap::papers
