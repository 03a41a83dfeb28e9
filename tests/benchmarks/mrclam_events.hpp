// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "host/datasets/log_record.hpp"
#include "host/models/odometry_motion.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

/// Robots of a set of UTIAS MRCLAM have the numbers 1 to this; what is above is a landmark.
inline constexpr std::int64_t kMrclamRobots = 5;

/// Something that a robot did, by what its wheels truly do of what they are commanded, or saw.
struct MrclamEvent {
  double stamp_s = 0.0;
  std::int64_t robot = 0;
  std::variant<datasets::OdometryStep, datasets::LandmarkSighting> record;
};

/// All of a set, in the order of time.
struct MrclamSet {
  std::vector<MrclamEvent> events;
  std::map<std::int64_t, TruePath> truths;
  std::map<std::int64_t, Eigen::Vector2d> landmarks_m;  ///< As surveyed.
};

/// Throws files::FileError.
MrclamSet read_mrclam(const std::filesystem::path& folder);

/// How its robots err, about as their residuals do against the true paths.
models::OdometryMotionParams mrclam_motion();
double mrclam_range_stddev_m(double range_m);
inline constexpr double kMrclamBearingStddevRad = 0.007;

}  // namespace echomap::bench
