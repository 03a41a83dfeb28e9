// SPDX-License-Identifier: MIT
#include "host/recording/observation_messages.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace echomap::recording {
namespace {

constexpr std::uint64_t kNow = 1'500'000'000;
constexpr SonarFacts kSonar{0.25, 0.04, 2.3};

sensors::SonarObservation ping(std::optional<double> range_m, bool has_answered = true) {
  return {time::RobotTime(), {}, 0.5, range_m, has_answered};
}

TEST(ObservationMessages, StampsAreSecondsAndNanoseconds) {
  EXPECT_EQ(stamp_of(kNow).sec, 1);
  EXPECT_EQ(stamp_of(kNow).nanosec, 500'000'000U);
}

TEST(ObservationMessages, OdometryIsTheRobotInItsFrame) {
  const auto message = odometry_message(kNow, {1.0, 2.0, std::numbers::pi / 2.0}, {0.5, -1.0});
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.child_frame_id, "base_link");
  EXPECT_EQ(message.twist.twist.linear.x, 0.5);
  EXPECT_EQ(message.twist.twist.angular.z, -1.0);
  EXPECT_EQ(message.pose.pose.position.y, 2.0);
  EXPECT_NEAR(message.pose.pose.orientation.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(message.pose.pose.orientation.w, std::sqrt(0.5), 1e-12);
}

TEST(ObservationMessages, APingWithoutEchoIsInfiniteAndOneUnansweredNoNumber) {
  EXPECT_FLOAT_EQ(sonar_message(kNow, ping(1.25), kSonar).range, 1.25F);
  EXPECT_TRUE(std::isinf(sonar_message(kNow, ping(std::nullopt), kSonar).range));
  EXPECT_TRUE(std::isnan(sonar_message(kNow, ping(std::nullopt, false), kSonar).range));
  EXPECT_FLOAT_EQ(sonar_message(kNow, ping(1.0), kSonar).field_of_view, 0.5F);
}

TEST(ObservationMessages, TheConeEndsAtTheEcho) {
  const auto cone = cone_message(kNow, ping(1.0), kSonar).markers.at(0);
  ASSERT_EQ(cone.points.size(), 9U);
  EXPECT_EQ(cone.points.front(), cone.points.back());
  EXPECT_NEAR(cone.points[4].x, 1.0, 1e-12) << "on the axis";
  EXPECT_NEAR(cone.points[1].y, -std::sin(0.25), 1e-12);
  EXPECT_NEAR(cone_message(kNow, ping(std::nullopt), kSonar).markers.at(0).points[4].x, 2.3, 1e-12);
}

TEST(ObservationMessages, WhatNobodyMeasuresIsMarked) {
  const auto imu = imu_message(kNow, {time::RobotTime(), {std::numbers::pi, 1.0, 0}});
  EXPECT_NEAR(imu.orientation.z, 1.0, 1e-12);
  EXPECT_EQ(imu.linear_acceleration_covariance[0], -1.0);
  const auto battery = battery_message(kNow, 7.5);
  EXPECT_FLOAT_EQ(battery.voltage, 7.5F);
  EXPECT_TRUE(std::isnan(battery.percentage));
  EXPECT_TRUE(std::isinf(infrared_message(kNow, "infrared_0", std::nullopt).range));
}

}  // namespace
}  // namespace echomap::recording
