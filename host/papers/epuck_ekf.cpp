// SPDX-License-Identifier: MIT
#include "host/papers/epuck_ekf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hil_mock/world/noise.hpp"
#include "host/geometry/angle.hpp"
#include "host/localization/pose_ekf.hpp"
#include "host/papers/drive_path.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr double kLapPeriodS = 0.1;
constexpr double kCameraStddevM = 0.002;
constexpr double kCameraStddevRad = 0.03;
/// Standard deviation of the wheels' errors, as a share of drive and turn.
constexpr double kWheelShare = 0.05;

/// Beside the walls of `epuck_field`, and between its blocks.
std::vector<Pose2> round_the_field() {
  const std::vector<Eigen::Vector2d> corners_m = {{0.10, 0.05},
                                                  {0.72, 0.05},
                                                  {0.72, 0.55},
                                                  {0.10, 0.55},
                                                  {0.10, 0.05},
                                                  {0.40, 0.30},
                                                  {0.68, 0.30}};
  return drive_path(corners_m, {.length_m = 0.01, .turn_rad = 0.1});
}

/// The odometry's step for a true one, off by a share of it.
Pose2 rolled(const Pose2& T_last_now, world::NoiseStream& noise) {
  const double stretch = 1.0 + kWheelShare * noise.normal();
  return {T_last_now.x_m() * stretch,
          T_last_now.y_m() * stretch,
          T_last_now.heading_rad() * (1.0 + kWheelShare * noise.normal()) +
              kWheelShare * T_last_now.position_m().norm() * noise.normal()};
}

/// A fix that has not arrived yet.
struct LateFix {
  int arrives_at = 0;
  localization::PoseFix fix;
};

localization::PoseFix fix_of(const Pose2& truth, double stamp_s, world::NoiseStream& noise) {
  localization::PoseFix fix;
  fix.stamp_s = stamp_s;
  fix.T_map_robot = Pose2(truth.x_m() + kCameraStddevM * noise.normal(),
                          truth.y_m() + kCameraStddevM * noise.normal(),
                          truth.heading_rad() + kCameraStddevRad * noise.normal());
  const Eigen::Vector3d variance(kCameraStddevM * kCameraStddevM,
                                 kCameraStddevM * kCameraStddevM,
                                 kCameraStddevRad * kCameraStddevRad);
  fix.covariance = variance.asDiagonal();
  return fix;
}

localization::PoseEkfParams ekf_params() {
  localization::PoseEkfParams params;
  // A step of the field's lap, as each has an error of its own.
  params.whole_step = {.drive_m = 0.01, .turn_rad = 0.1};
  params.motion.alpha1 = kWheelShare * kWheelShare;
  params.motion.alpha2_rad2_per_m2 = kWheelShare * kWheelShare;
  params.motion.alpha3 = kWheelShare * kWheelShare;
  return params;
}

/// The camera with the fixes that are under way.
class FixQueue {
 public:
  FixQueue(const OverheadCamera& camera, world::NoiseStream& noise)
      : camera_(camera), noise_(noise) {}

  /// Takes an image of this step, if it is time for one, and returns the position in it.
  std::optional<Eigen::Vector2d> look(int step, const Pose2& T_world_robot) {
    if (step % camera_.every_steps != 0 || step >= camera_.until_step ||
        noise_.uniform() < camera_.drop_share) {
      return std::nullopt;
    }
    const int delay = static_cast<int>((camera_.max_delay_steps + 1) * noise_.uniform());
    late_.push_back({step + delay, fix_of(T_world_robot, kLapPeriodS * step, noise_)});
    return late_.back().fix.T_map_robot.position_m();
  }
  /// Hands over what has arrived by this step.
  void deliver(int step, localization::PoseEkf& filter) {
    const auto due = std::stable_partition(
        late_.begin(), late_.end(), [&](const LateFix& late) { return late.arrives_at > step; });
    std::for_each(due, late_.end(), [&](const LateFix& late) { filter.update(late.fix); });
    late_.erase(due, late_.end());
  }

 private:
  OverheadCamera camera_;
  world::NoiseStream& noise_;
  std::vector<LateFix> late_;
};

}  // namespace

OverheadCamera late_camera() { return {.every_steps = 3, .drop_share = 0.2, .max_delay_steps = 6}; }

localization::PoseGaussian anywhere_in_the_field() {
  const Eigen::Vector3d variance(0.4 * 0.4, 0.3 * 0.3, std::numbers::pi * std::numbers::pi);
  return {Pose2(0.4, 0.3, 0.0), variance.asDiagonal()};
}

EkfDrive follow_epuck(const OverheadCamera& camera, std::uint32_t seed) {
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  localization::PoseEkf filter(anywhere_in_the_field(), ekf_params());
  FixQueue fixes(camera, noise);
  const std::vector<Pose2> truth = round_the_field();
  Pose2 T_odom_robot;
  EkfDrive drive;
  for (int i = 0; i < static_cast<int>(truth.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i > 0) {
      T_odom_robot = T_odom_robot * rolled(truth[at - 1].inverse() * truth[at], noise);
    }
    filter.move(kLapPeriodS * i, T_odom_robot);
    const auto fix_m = fixes.look(i, truth[at]);
    fixes.deliver(i, filter);
    drive.steps.push_back({truth[at], filter.belief(), fix_m});
  }
  drive.gated = filter.count(localization::EkfOutcome::kGated);
  return drive;
}

Eigen::Vector3d error_of(const EkfStep& step) {
  const Pose2& estimate = step.belief.T_map_robot;
  const Eigen::Vector2d offset_m = estimate.position_m() - step.T_world_robot.position_m();
  return {offset_m.x(),
          offset_m.y(),
          geometry::angle_between(step.T_world_robot.heading_rad(), estimate.heading_rad())};
}

double planar_stddev_m(const EkfStep& step) {
  return std::sqrt(step.belief.covariance.topLeftCorner<2, 2>().trace());
}

double share_beyond_three_sigma(const EkfDrive& drive) {
  double beyond = 0.0;
  for (const EkfStep& step : drive.steps) {
    const Eigen::Array3d bounds = 3.0 * step.belief.covariance.diagonal().cwiseSqrt().array();
    beyond += static_cast<double>((error_of(step).cwiseAbs().array() > bounds).count());
  }
  return beyond / (3.0 * static_cast<double>(drive.steps.size()));
}

}  // namespace echomap::papers
