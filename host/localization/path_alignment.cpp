// SPDX-License-Identifier: MIT
#include "host/localization/path_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/localization/pose_lattice.hpp"
#include "host/models/odometry_motion.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// Readings of a scan err together, so that they weigh as so many against odometry.
constexpr double kIndependentReadings = 10.0;
/// How far a pose is tried to each side in the first round, and its share in each later one.
constexpr double kFirstStepM = 0.1;
constexpr double kFirstStepRad = 0.1;
constexpr double kNextStep = 0.6;
constexpr int kRounds = 3;

/// What odometry tells of the way from one scan to the next.
class OdometryLink {
 public:
  OdometryLink(const Pose2& T_odom_before, const Pose2& T_odom_after)
      : T_before_after_(T_odom_before.inverse() * T_odom_after) {
    // Where a robot stands and turns on its pivot it errs as well.
    constexpr double kStandingM = 0.02;
    constexpr double kStandingRad = 0.02;
    const models::MotionSpread spread =
        models::OdometryMotion().spread(models::odometry_step(T_odom_before, T_odom_after));
    stddev_m_ = kStandingM + spread.drive_m;
    stddev_rad_ = kStandingRad + std::hypot(spread.turn_before_rad, spread.turn_after_rad);
  }

  /// Natural logarithm of how likely two poses are by it, up to a constant.
  double log_likelihood(const Pose2& T_map_before, const Pose2& T_map_after) const {
    const Pose2 T_before_after = T_map_before.inverse() * T_map_after;
    const double off_m = (T_before_after.position_m() - T_before_after_.position_m()).norm();
    const double off_rad =
        geometry::angle_between(T_before_after.heading_rad(), T_before_after_.heading_rad());
    return -0.5 * (geometry::square(off_m / stddev_m_) + geometry::square(off_rad / stddev_rad_));
  }

 private:
  Pose2 T_before_after_;
  double stddev_m_ = 0.0;
  double stddev_rad_ = 0.0;
};

/// One from each scan but the newest to the next newer one.
std::vector<OdometryLink> links_of(std::span<const StopScan> scans) {
  std::vector<OdometryLink> links;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    links.emplace_back(scans[i].T_odom_robot, scans[i - 1].T_odom_robot);
  }
  return links;
}

/// The likeliest of the poses around one of the path by the scan that the model observes, and by
/// the poses before and after it.
Pose2 aligned_pose(ObservationModel& model,
                   const std::vector<OdometryLink>& links,
                   const ScanPath& path,
                   std::size_t i,
                   double step) {
  Particles particles = poses_around(path[i], step * kFirstStepM, step * kFirstStepRad);
  set_log_likelihoods(model, particles);
  const double scale =
      kIndependentReadings / std::max(kIndependentReadings, static_cast<double>(model.count()));
  Pose2 best = path[i];
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Pose2 T_map_robot = particles.pose(k);
    double log_posterior = scale * static_cast<double>(particles.log_weight[k]);
    if (i > 0) {
      log_posterior += links[i - 1].log_likelihood(T_map_robot, path[i - 1]);
    }
    if (i < links.size()) {
      log_posterior += links[i].log_likelihood(path[i + 1], T_map_robot);
    }
    if (log_posterior > most) {
      most = log_posterior;
      best = T_map_robot;
    }
  }
  return best;
}

}  // namespace

ScanPath path_by_odometry(std::span<const StopScan> scans, const Pose2& T_map_robot) {
  ScanPath path;
  for (const StopScan& scan : scans) {
    path.push_back(T_map_robot * (scans.front().T_odom_robot.inverse() * scan.T_odom_robot));
  }
  return path;
}

void align_paths(std::span<const StopScan> scans,
                 ObservationModel& model,
                 std::span<ScanPath> paths) {
  const std::vector<OdometryLink> links = links_of(scans);
  if (links.empty()) {
    return;
  }
  double step = 1.0;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < scans.size(); ++i) {
      model.observe(all_readings(scans[i]));
      for (ScanPath& path : paths) {
        path[i] = aligned_pose(model, links, path, i, step);
      }
    }
    step *= kNextStep;
  }
}

}  // namespace echomap::localization
