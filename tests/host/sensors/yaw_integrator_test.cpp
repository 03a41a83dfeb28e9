// SPDX-License-Identifier: MIT
#include "host/sensors/yaw_integrator.hpp"

#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

using protocol::Gyro;
using std::numbers::pi;

/// 250 degrees a second at 32768 counts, 100 samples a second.
constexpr GyroParams kGyro{
    .full_scale_rad_per_s = 250.0 * pi / 180.0, .sample_period_s = 0.01, .upside_down = false};

TEST(YawIntegrator, TurnsSumsIntoAngles) {
  YawIntegrator yaw(kGyro);
  yaw.update(Gyro{0, 5000, 10, 0});
  // A hundred samples of half the scale: one second at 125 degrees a second.
  const Yaw turned = yaw.update(Gyro{0, 5000 + 100 * 16384, 110, 3});
  EXPECT_NEAR(turned.yaw_rad, 125.0 * pi / 180.0, 1e-12);
  EXPECT_NEAR(turned.measured_s, 1.0, 1e-12);
  EXPECT_EQ(turned.errors, 3U);
}

TEST(YawIntegrator, KnowsWhichWayIsLeft) {
  GyroParams upside_down = kGyro;
  upside_down.upside_down = true;
  YawIntegrator yaw(kGyro);
  YawIntegrator other(upside_down);
  yaw.update(Gyro{});
  other.update(Gyro{});
  EXPECT_GT(yaw.update(Gyro{0, 1000, 1, 0}).yaw_rad, 0.0);
  EXPECT_LT(other.update(Gyro{0, 1000, 1, 0}).yaw_rad, 0.0);
}

TEST(YawIntegrator, GoesOnThroughWrapsAndLostMessages) {
  YawIntegrator yaw(kGyro);
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  yaw.update(Gyro{0, kMost - 100, 65'530, 65'535});
  const Yaw turned = yaw.update(Gyro{0, std::numeric_limits<std::int32_t>::min() + 99, 4, 1});
  EXPECT_NEAR(turned.yaw_rad, 200 * kGyro.full_scale_rad_per_s / 32768.0 * 0.01, 1e-12);
  EXPECT_NEAR(turned.measured_s, 0.10, 1e-12);
  EXPECT_EQ(turned.errors, 2U);
}

TEST(YawIntegrator, GoesOnAfterAReset) {
  YawIntegrator yaw(kGyro);
  yaw.update(Gyro{0, 7'000'000, 500, 0});
  const double before_rad = yaw.update(Gyro{0, 7'100'000, 600, 0}).yaw_rad;
  yaw.restart();
  const Yaw after = yaw.update(Gyro{0, 100'000, 100, 0});
  EXPECT_NEAR(after.yaw_rad, 2.0 * before_rad, 1e-12);
  EXPECT_NEAR(after.measured_s, 2.0, 1e-12);
}

TEST(YawIntegrator, LeavesAGapOutThatIsTooLongToTell) {
  YawIntegrator yaw(kGyro);
  constexpr std::uint32_t kStartUs = 4'000'000'000;
  constexpr std::uint32_t kGapUs = 328'000'000;  // 32,800 samples.
  yaw.update(Gyro{kStartUs, 0, 0, 0});
  const Yaw before = yaw.update(Gyro{kStartUs + 1'000'000, 5000, 100, 0});
  const Yaw after = yaw.update(Gyro{kStartUs + kGapUs + 1'000'000, 9'000'000, 32'900, 0});
  EXPECT_EQ(after.yaw_rad, before.yaw_rad);
  EXPECT_EQ(after.measured_s, before.measured_s);
  const Yaw later = yaw.update(Gyro{kStartUs + kGapUs + 2'000'000, 9'005'000, 33'000, 0});
  EXPECT_NEAR(later.yaw_rad, 2.0 * before.yaw_rad, 1e-12);
  EXPECT_NEAR(later.measured_s, 2.0, 1e-12);
}

TEST(YawIntegrator, RefusesAScaleOfNothing) {
  EXPECT_THROW(YawIntegrator(GyroParams{}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors
