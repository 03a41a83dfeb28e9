// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "host/slam/ekf_slam_filter.hpp"
#include "tests/benchmarks/gps_track.hpp"
#include "tests/benchmarks/landmark_runs.hpp"

namespace echomap::bench {

/// 99.9 % of chi square with two degrees of freedom: barcodes are misread.
inline constexpr double kGate = 13.82;

/// How well EKF-SLAM found robots and landmarks.
struct LandmarkSlamScore {
  std::vector<FollowScore> robots;  ///< At every odometry pose; nothing aligned.
  /// Of the landmarks at the end: as they are, and laid onto the surveyed ones without scale.
  double landmark_m = 0.0;
  double aligned_landmark_m = 0.0;
  double landmark_nees = 0.0;  ///< Mean over the landmarks; 2 is right.
  std::size_t landmarks = 0;
};

/// Robots 1 to 5 of a folder of UTIAS MRCLAM from their true poses on, the landmarks unknown but
/// for their numbers: all in one filter, that also takes their sightings of each other. Throws
/// files::FileError.
LandmarkSlamScore slam_mrclam_team(const std::filesystem::path& folder,
                                   const slam::EkfSlamFilterParams& params = {});
/// One of them alone.
LandmarkSlamScore slam_mrclam_robot(const std::filesystem::path& folder,
                                    std::int64_t robot,
                                    const slam::EkfSlamFilterParams& params = {});

/// Brenner's LEGO robot among cylinders of which only the diameter is known, from its known start
/// on, at its scanner; the reference made smaller as in landmark_runs.hpp. Throws files::FileError.
LandmarkSlamScore slam_brenner(const std::filesystem::path& folder);

/// EKF-SLAM among trees that are known by their numbers.
struct TreeSlamRun {
  std::vector<geometry::Pose2> T_map_robots;   ///< After each step, by what was known then.
  std::vector<geometry::Pose2> T_odom_robots;  ///< The same by odometry alone.
  double innovation_nees = 0.0;                ///< Mean over the updates; 2 is right.
  std::size_t updates = 0;
  std::size_t gated = 0;
  std::size_t trees = 0;
};

/// Victoria Park (Guivant and Nebot 2001), as gtsam gives it. Throws files::FileError.
TreeSlamRun slam_victoria_park(const std::filesystem::path& folder,
                               const slam::EkfSlamFilterParams& params = {});
/// How a path of it lies to its GPS fixes; those that would have the truck leap are left out.
/// Throws files::FileError.
GpsAgreement victoria_park_agreement(const std::filesystem::path& folder,
                                     std::span<const geometry::Pose2> T_map_robots);

}  // namespace echomap::bench
