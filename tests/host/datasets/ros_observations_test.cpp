// SPDX-License-Identifier: MIT
#include "host/datasets/ros_observations.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "tests/support/bag_writer.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using testing::HasSubstr;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::optional<double> returned_m(float range_m) {
  ros_messages::Range range = tests::ros_range(0.0, "sonar", 1.0);
  range.range = range_m;
  return scan_of(range).beams.at(0).range_m;
}

TEST(RosObservations, ARangeIsOneBeamAsWideAsItsFieldOfView) {
  const auto scan = scan_of(tests::ros_range(3.0, "sonar", 1.5));
  EXPECT_EQ(scan.beams, (std::vector<sensors::Beam>{{0.0, 1.5}}));
  EXPECT_FLOAT_EQ(static_cast<float>(scan.beam_width_rad), 0.26F);
  EXPECT_EQ(scan.max_range_m, 4.0);
  EXPECT_FALSE(scan.is_light);
}

TEST(RosObservations, ARangeOutsideOfItsLimitsIsSilence) {
  EXPECT_EQ(returned_m(0.02F), 0.02F);
  for (const float range_m : {0.01F, 4.0F, 4.5F, kInfinite, -kInfinite, kNaN, 0.0F, -1.0F}) {
    EXPECT_EQ(returned_m(range_m), std::nullopt) << range_m;
  }
}

TEST(RosObservations, InfraRedIsLight) {
  ros_messages::Range range = tests::ros_range(0.0, "ranger", 1.0);
  range.radiation_type = ros_messages::Range::kInfrared;
  EXPECT_TRUE(scan_of(range).is_light);
}

TEST(RosObservations, ARangeBeyondTwentyMetresIsSilence) {
  ros_messages::Range range = tests::ros_range(0.0, "ranger", 25.0);
  range.max_range = 40.0F;
  EXPECT_EQ(scan_of(range).beams.at(0).range_m, std::nullopt);
  EXPECT_EQ(scan_of(range).max_range_m, 20.0);
}

template <class Reading>
std::string refusal_of_scan(const Reading& reading) {
  return tests::thrown_text<files::FileError>([&] { scan_of(reading); });
}

TEST(RosObservations, RefusesConesThatAreNone) {
  ros_messages::Range range = tests::ros_range(0.0, "sonar", 1.0);
  for (const float width_rad : {-0.1F, 1.6F, 15.0F}) {
    range.field_of_view = width_rad;
    EXPECT_THAT(refusal_of_scan(range), HasSubstr("field_of_view = ")) << width_rad;
  }
  range.field_of_view = kNaN;
  EXPECT_THAT(refusal_of_scan(range), HasSubstr("field_of_view is not a finite number"));
  range.field_of_view = 0.2F;
  range.max_range = 0.0F;
  EXPECT_THAT(refusal_of_scan(range), HasSubstr("max_range = 0.000000 is not above 0"));
}

ros_messages::LaserScan small_sweep() {
  ros_messages::LaserScan sweep;
  sweep.angle_min = -0.5F;
  sweep.angle_increment = 0.25F;
  sweep.range_min = 0.1F;
  sweep.range_max = 8.0F;
  sweep.ranges = {1.0F, kInfinite, kNaN, 0.05F, 8.5F, 2.0F};
  return sweep;
}

TEST(RosObservations, ASweepHasItsBeamsCounterClockwise) {
  const auto scan = scan_of(small_sweep());
  ASSERT_EQ(scan.beams.size(), 6U);
  EXPECT_EQ(scan.beams[0], (sensors::Beam{-0.5, 1.0}));
  EXPECT_EQ(scan.beams[5], (sensors::Beam{0.75, 2.0}));
  for (int i = 1; i < 5; ++i) {
    EXPECT_EQ(scan.beams.at(static_cast<std::size_t>(i)).range_m, std::nullopt) << i;
  }
  EXPECT_EQ(scan.beam_width_rad, 0.0);
  EXPECT_EQ(scan.max_range_m, 8.0);
  EXPECT_TRUE(scan.is_light);
}

TEST(RosObservations, RefusesASweepWithoutAngles) {
  ros_messages::LaserScan sweep = small_sweep();
  sweep.angle_increment = kNaN;
  EXPECT_THAT(refusal_of_scan(sweep), HasSubstr("angle_increment is not a finite number"));
  sweep = small_sweep();
  sweep.range_max = kInfinite;
  EXPECT_THAT(refusal_of_scan(sweep), HasSubstr("range_max is not a finite number"));
}

TEST(RosObservations, FramesHaveNoSlashBeforeThem) {
  EXPECT_EQ(frame_name("/base_link"), "base_link");
  EXPECT_EQ(frame_name("robot/base_link"), "robot/base_link");
  EXPECT_EQ(frame_name(""), "");
}

TEST(RosObservations, StampsAreSeconds) {
  EXPECT_DOUBLE_EQ(seconds_of({3, 250'000'000}), 3.25);
  EXPECT_DOUBLE_EQ(seconds_of({-1, 250'000'000}), -0.75);
}

TEST(RosObservations, APoseOfThePlaneIsWhereXLooks) {
  ros_messages::Pose pose;
  pose.position = {1.0, 2.0, 3.0};
  pose.orientation = tests::ros_turn(radians(120.0));
  const auto T_a_b = planar_pose(spatial_pose(pose));
  EXPECT_EQ(T_a_b.x_m(), 1.0);
  EXPECT_EQ(T_a_b.y_m(), 2.0);
  EXPECT_NEAR(T_a_b.heading_rad(), radians(120.0), 1e-12);
}

TEST(RosObservations, RefusesWhatIsNoRotation) {
  ros_messages::Pose pose;
  pose.orientation = {0.0, 0.0, 0.0, 0.0};
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { spatial_pose(pose); }),
              HasSubstr("length 0.000000, not 1"));
  pose.orientation = {0.0, 0.0, 0.0, std::nan("")};
  EXPECT_THROW(spatial_pose(pose), files::FileError);
  pose.orientation = {};
  pose.position.z = std::numeric_limits<double>::infinity();
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { spatial_pose(pose); }),
              HasSubstr("the position is not within 1e9 m"));
}

/// A sensor turned about one axis.
SpatialPose turned(const Eigen::Vector3d& axis, double angle_deg) {
  return {{0.1, 0.2, 0.3}, Eigen::Quaterniond(Eigen::AngleAxisd(radians(angle_deg), axis))};
}

TEST(RosObservations, ALaserUpsideDownLooksTheOtherWayRound) {
  auto scan = scan_of(small_sweep());
  EXPECT_TRUE(place_on_robot(turned(Eigen::Vector3d::UnitX(), 180.0), scan));
  EXPECT_EQ(scan.beams[0].bearing_rad, 0.5);
  EXPECT_NEAR(scan.T_robot_sensor.heading_rad(), 0.0, 1e-12);
  EXPECT_EQ(scan.T_robot_sensor.x_m(), 0.1);
}

TEST(RosObservations, BeamsThatLookUpOrDownAreNotOfThePlane) {
  auto sweep = scan_of(small_sweep());
  EXPECT_TRUE(place_on_robot(turned(Eigen::Vector3d::UnitY(), 20.0), sweep));
  EXPECT_FALSE(place_on_robot(turned(Eigen::Vector3d::UnitY(), 40.0), sweep));
  EXPECT_FALSE(place_on_robot(turned(Eigen::Vector3d::UnitX(), 90.0), sweep));
  auto ping = scan_of(tests::ros_range(0.0, "sonar", 1.0));
  EXPECT_TRUE(place_on_robot(turned(Eigen::Vector3d::UnitX(), 90.0), ping));
  EXPECT_FALSE(place_on_robot(turned(Eigen::Vector3d::UnitY(), 90.0), ping));
}

}  // namespace
}  // namespace echomap::datasets
