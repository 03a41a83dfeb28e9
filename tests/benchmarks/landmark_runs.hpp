// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

namespace echomap::bench {

/// How well a filter followed a robot whose true path is known, at every odometry pose.
struct FollowScore {
  double mean_m = 0.0;
  double rmse_m = 0.0;
  double dead_reckoning_mean_m = 0.0;
  /// Mean normalized squared error by the filter's own covariance: of x, y and heading, or of x and
  /// y alone where no true heading is known.
  double nees = 0.0;
  std::size_t poses = 0;
  std::size_t gated = 0;
};

/// Brenner's LEGO robot among its known cylinders, from its known start on, at its scanner, which
/// is what the camera overhead followed. With `scaled` the reference is made smaller around its
/// middle first: the scanner stands nearer to the camera than the floor. Throws files::FileError.
FollowScore follow_brenner(const std::filesystem::path& folder, bool scaled);

}  // namespace echomap::bench
