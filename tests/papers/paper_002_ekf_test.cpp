// SPDX-License-Identifier: MIT
// Mahmood and Ridao 2017, section 4.1, EKF localization: an e-puck under a camera in its field. The
// filter starts in the middle, unsure of all of the field. The paper names no noise; ours is that
// of a camera of millimetre pixels that tells late and now and then not at all.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/world/noise.hpp"
#include "host/geometry/angle.hpp"
#include "host/localization/pose_ekf.hpp"
#include "tests/papers/drive_path.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;
using localization::EkfOutcome;
using localization::PoseEkf;

constexpr double kLapPeriodS = 0.1;
constexpr double kCameraStddevM = 0.002;
constexpr double kCameraStddevRad = 0.03;
constexpr int kCameraEvery = 3;
constexpr double kDropOuts = 0.2;
constexpr double kWheelShare = 0.05;
const Pose2 field_middle(0.4, 0.3, 0.0);

/// How the filter followed one drive.
struct Follow {
  std::vector<double> position_stddev_m;
  std::vector<Eigen::Vector3d> error;
  std::size_t outside = 0;
  std::size_t judged = 0;
  std::size_t gated = 0;
};

localization::PoseGaussian anywhere_in_the_field() {
  const Eigen::Vector3d variance(0.4 * 0.4, 0.3 * 0.3, std::numbers::pi * std::numbers::pi);
  return {field_middle, variance.asDiagonal()};
}

Eigen::Vector3d error_of(const Pose2& believed, const Pose2& truth) {
  return {believed.x_m() - truth.x_m(),
          believed.y_m() - truth.y_m(),
          geometry::angle_between(truth.heading_rad(), believed.heading_rad())};
}

/// An e-puck's field is 0.8 m by 0.6 m.
std::vector<Pose2> lap() {
  return drive_path({{0.1, 0.1}, {0.7, 0.1}, {0.7, 0.5}, {0.1, 0.5}, {0.1, 0.1}, {0.6, 0.45}},
                    {.length_m = 0.01, .turn_rad = 0.1});
}

/// The odometry's step for a true one, off by a share of it.
Pose2 rolled(const Pose2& T_last_now, world::NoiseStream& noise) {
  const double stretch = 1.0 + kWheelShare * noise.normal();
  return {T_last_now.x_m() * stretch,
          T_last_now.y_m() * stretch,
          T_last_now.heading_rad() * (1.0 + kWheelShare * noise.normal()) +
              kWheelShare * T_last_now.position_m().norm() * noise.normal()};
}

/// A camera's pose that has waited for its turn.
struct Late {
  int told_at = 0;
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

localization::PoseEkfParams epuck() {
  localization::PoseEkfParams params;
  // A step of the field's lap, as each has an error of its own.
  params.whole_step = {.drive_m = 0.01, .turn_rad = 0.1};
  params.motion.alpha1 = kWheelShare * kWheelShare;
  params.motion.alpha2_rad2_per_m2 = kWheelShare * kWheelShare;
  params.motion.alpha3 = kWheelShare * kWheelShare;
  return params;
}

/// Drives a lap; the camera tells until pose `camera_until`, each time up to 0.6 s late.
Follow drive(std::uint32_t seed, int camera_until) {
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  PoseEkf filter(anywhere_in_the_field(), epuck());
  const std::vector<Pose2> truth = lap();
  std::vector<Late> on_the_way;
  Pose2 T_odom_robot;
  Follow follow;
  for (int i = 0; i < static_cast<int>(truth.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    T_odom_robot =
        i == 0 ? Pose2() : T_odom_robot * rolled(truth[at - 1].inverse() * truth[at], noise);
    filter.move(kLapPeriodS * i, T_odom_robot);
    if (i % kCameraEvery == 0 && i < camera_until && noise.uniform() > kDropOuts) {
      const int delay = static_cast<int>(7.0 * noise.uniform());
      on_the_way.push_back({i + delay, fix_of(truth[at], kLapPeriodS * i, noise)});
    }
    const auto due = std::stable_partition(
        on_the_way.begin(), on_the_way.end(), [&](const Late& late) { return late.told_at > i; });
    std::for_each(due, on_the_way.end(), [&](const Late& late) { filter.update(late.fix); });
    on_the_way.erase(due, on_the_way.end());
    const Eigen::Vector3d sd = filter.belief().covariance.diagonal().cwiseSqrt();
    follow.error.push_back(error_of(filter.belief().T_map_robot, truth[at]));
    follow.position_stddev_m.push_back(sd.head<2>().norm());
    const auto is_outside = follow.error.back().cwiseAbs().array() > 3.0 * sd.array();
    follow.outside += static_cast<std::size_t>(is_outside.count());
    follow.judged += 3;
  }
  follow.gated = filter.count(EkfOutcome::kGated);
  return follow;
}

TEST(Paper002Ekf, ErrorsStayWithinThreeSigma) {
  std::size_t outside = 0;
  std::size_t judged = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const Follow follow = drive(seed, 1000);
    EXPECT_LE(follow.gated, 2U) << seed;
    EXPECT_LT(follow.error.back().head<2>().norm(), 0.01) << seed;
    outside += follow.outside;
    judged += follow.judged;
  }
  // 0.27 % of a normal distribution.
  EXPECT_LT(static_cast<double>(outside), 0.006 * static_cast<double>(judged));
}

TEST(Paper002Ekf, BeliefNarrowsFromAllOfTheFieldToAFewMillimetres) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Follow follow = drive(seed, 1000);
    EXPECT_GT(follow.position_stddev_m.front(), 0.002) << seed;
    EXPECT_LT(follow.position_stddev_m[76], 0.005) << seed;
    EXPECT_LT(follow.error[76].head<2>().norm(), 0.01) << seed;
  }
}

TEST(Paper002Ekf, WithoutTheCameraItFollowsOnAndGrowsUnsure) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Follow follow = drive(seed, 80);
    const std::size_t last = follow.error.size() - 1;
    EXPECT_GT(follow.position_stddev_m[last], 2.0 * follow.position_stddev_m[80]) << seed;
    EXPECT_LT(follow.error[last].head<2>().norm(), 4.0 * follow.position_stddev_m[last]) << seed;
  }
}

}  // namespace
}  // namespace echomap::papers
