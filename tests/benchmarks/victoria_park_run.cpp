// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "host/datasets/companion_file.hpp"
#include "host/models/cut_step_spread.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "tests/benchmarks/ekf_slam_runs.hpp"
#include "tests/benchmarks/gps_track.hpp"
#include "tests/benchmarks/mat_file.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

/// A tree's trunk by a laser of half a degree, up to 20 m away, its middle taken from what is seen.
constexpr double kTrunkStddevM = 0.3;
constexpr double kTrunkStddevRad = 0.02;

/// Faster than this the truck was not: a fix that says so is a wrong one. Above it by a few metres
/// of what fixes err.
constexpr double kMaxSpeedMPerS = 8.0;
constexpr double kMaxGpsErrorM = 10.0;

bool is_within_reach(const GpsFix& before, const GpsFix& after) {
  const double reach_m = kMaxGpsErrorM + kMaxSpeedMPerS * (after.stamp_s - before.stamp_s);
  return (after.position_m - before.position_m).norm() <= reach_m;
}

std::vector<GpsFix> read_gps(const std::filesystem::path& folder) {
  const auto variables = read_mat_file(folder / "aa3_gpsx.mat");
  const auto& stamps_ms = variables.at("timeGps");
  std::vector<GpsFix> fixes;
  for (std::size_t i = 0; i < stamps_ms.size(); ++i) {
    const GpsFix fix{stamps_ms[i] / 1000.0,
                     {variables.at("Lo_m").at(i), variables.at("La_m").at(i)}};
    if (fixes.empty() || is_within_reach(fixes.back(), fix)) {
      fixes.push_back(fix);
    }
  }
  return fixes;
}

/// Trees by their numbers.
class TreeSlam {
 public:
  explicit TreeSlam(const slam::EkfSlamFilterParams& params) : filter_(params) {}

  void move(const Pose2& T_last_now) {
    T_odom_robot_ = T_odom_robot_ * T_last_now;
    const models::OdometryStep step = models::odometry_step({}, T_last_now);
    filter_.move(0, T_last_now, step, models::cut_step_spread(motion_, step, {}));
    score_.T_map_robots.push_back(filter_.belief().T_map_robot);
    score_.T_odom_robots.push_back(T_odom_robot_);
  }

  void see(std::int64_t tree, const Eigen::Vector2d& at_m) {
    slam::LandmarkSighting sighting;
    sighting.value = {at_m.norm(), std::atan2(at_m.y(), at_m.x())};
    sighting.noise =
        Eigen::Vector2d(kTrunkStddevM * kTrunkStddevM, kTrunkStddevRad * kTrunkStddevRad)
            .asDiagonal();
    const auto known = indices_.find(tree);
    if (known == indices_.end()) {
      indices_[tree] = filter_.add(sighting);
      return;
    }
    const auto linear = filter_.linearized(sighting, known->second);
    if (linear && filter_.squared_distance(*linear) <= kGate) {
      score_.innovation_nees += filter_.squared_distance(*linear);
      ++score_.updates;
      filter_.update({&*linear, 1});
      score_.T_map_robots.back() = filter_.belief().T_map_robot;
    } else {
      ++score_.gated;
    }
  }

  TreeSlamRun run() const {
    TreeSlamRun run = score_;
    run.innovation_nees /= static_cast<double>(run.updates);
    run.trees = indices_.size();
    return run;
  }

 private:
  models::OdometryMotion motion_;
  slam::EkfSlamFilter filter_;
  Pose2 T_odom_robot_;
  std::map<std::int64_t, std::size_t> indices_;
  TreeSlamRun score_;
};

/// The poses of the log stand at its laser's scans, less those at which the truck stood.
constexpr double kScanPeriodS = 1.0 / 4.7;
constexpr double kMaxStoodS = 160.0;

}  // namespace

TreeSlamRun slam_victoria_park(const std::filesystem::path& folder,
                               const slam::EkfSlamFilterParams& params) {
  TreeSlam slam(params);
  datasets::CompanionLines lines(folder / "victoria_park_gtsam.txt.gz");
  while (auto fields = lines.next()) {
    const auto kind = fields->word("the kind");
    fields->skip(1);
    const std::int64_t to = fields->integer("a node");
    const double x_m = fields->number("x");
    const double y_m = fields->number("y");
    if (kind == "ODOMETRY") {
      slam.move({x_m, y_m, fields->number("a turn")});
    } else {
      slam.see(to, {x_m, y_m});
    }
  }
  return slam.run();
}

GpsAgreement victoria_park_agreement(const std::filesystem::path& folder,
                                     std::span<const Pose2> T_map_robots) {
  return agreement_with_gps(T_map_robots, read_gps(folder), kScanPeriodS, kMaxStoodS);
}

}  // namespace echomap::bench
