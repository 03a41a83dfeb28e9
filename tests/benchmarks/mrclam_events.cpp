// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mrclam_events.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/mrclam_log.hpp"
#include "tests/support/log_files.hpp"

namespace echomap::bench {

namespace {

/// The log's odometry is what was commanded. The robots follow it that much later and less far:
/// measured by the true paths of all five, then chosen, as all below, for the error on this set.
constexpr double kCommandLeadS = 0.2;
constexpr double kDriveShare = 0.92;
constexpr double kTurnShare = 0.88;
/// Ranges count less than they err, as pictures in a row err alike.
constexpr double kRangeStddevM = 0.02;
constexpr double kRangeStddevShare = 0.1;
/// A picture is stamped when it has been read.
constexpr double kPictureAgeS = 0.05;

std::map<std::int64_t, Eigen::Vector2d> read_barcodes(const std::filesystem::path& path) {
  std::map<std::int64_t, Eigen::Vector2d> landmarks_m;
  datasets::CompanionLines lines(path);
  while (auto fields = lines.next()) {
    const std::int64_t id = fields->integer("the landmark");
    const double x_m = fields->number("x");
    const double y_m = fields->number("y");
    landmarks_m[id] = {x_m, y_m};
  }
  return landmarks_m;
}

datasets::OdometryStep as_driven(datasets::OdometryStep commanded) {
  const geometry::Pose2& step = commanded.T_last_now;
  commanded.T_last_now = geometry::Pose2(
      kDriveShare * step.x_m(), kDriveShare * step.y_m(), kTurnShare * step.heading_rad());
  return commanded;
}

void read_robot(const std::filesystem::path& folder, std::int64_t number, MrclamSet& set) {
  const auto log =
      datasets::open_mrclam_log(folder / ("Robot" + std::to_string(number) + "_Odometry.dat.gz"));
  // One picture shows several barcodes: the first has its stamp.
  double picture_s = 0.0;
  while (auto record = log->next()) {
    const auto stamp_s = datasets::stamp_s(*record);
    if (const auto* given = std::get_if<datasets::GivenPose>(&*record)) {
      if (stamp_s) {
        set.truths[number].add(*stamp_s, given->T_map_robot);
      }
    } else if (const auto* seen = std::get_if<datasets::LandmarkSighting>(&*record)) {
      picture_s = stamp_s.value_or(picture_s);
      set.events.push_back({picture_s - kPictureAgeS, number, *seen});
    } else if (const auto* step = std::get_if<datasets::OdometryStep>(&*record); step && stamp_s) {
      set.events.push_back({*stamp_s + kCommandLeadS, number, as_driven(*step)});
    }
  }
}

}  // namespace

MrclamSet read_mrclam(const std::filesystem::path& folder) {
  MrclamSet set;
  set.landmarks_m = read_barcodes(folder / "Landmark_Groundtruth.dat.gz");
  for (std::int64_t number = 1; number <= kMrclamRobots; ++number) {
    read_robot(folder, number, set);
  }
  std::stable_sort(
      set.events.begin(), set.events.end(), [](const MrclamEvent& left, const MrclamEvent& right) {
        return left.stamp_s < right.stamp_s;
      });
  return set;
}

models::OdometryMotionParams mrclam_motion() {
  models::OdometryMotionParams motion;
  motion.alpha1 = 0.04;
  motion.alpha2_rad2_per_m2 = 0.03;
  motion.alpha3 = 0.02;
  return motion;
}

double mrclam_range_stddev_m(double range_m) {
  return std::hypot(kRangeStddevM, kRangeStddevShare * range_m);
}

}  // namespace echomap::bench
