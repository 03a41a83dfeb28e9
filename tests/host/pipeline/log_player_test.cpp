// SPDX-License-Identifier: MIT
#include "host/pipeline/log_player.hpp"

#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "tests/support/played_log.hpp"

namespace echomap::pipeline {
namespace {

using datasets::Contact;
using datasets::GivenPose;
using datasets::Heading;
using datasets::LandmarkSighting;
using datasets::OdometryPose;
using datasets::OdometryStep;
using datasets::WheelIncrement;
using geometry::Pose2;
using sensors::RangeScan;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

constexpr double kRightAngleRad = std::numbers::pi / 2.0;

/// Writes down what is played.
class Listener final : public tests::OdometrySink {
 public:
  void on_odometry_pose(const sensors::OdometryPoseObservation& observation) override {
    OdometrySink::on_odometry_pose(observation);
    stamps_s.push_back(static_cast<double>(observation.stamp.time_since_epoch().count()) * 1e-6);
  }
  void on_pose_fix(const sensors::PoseFixObservation& observation) override {
    fixes.push_back(observation.T_map_robot);
  }
  void on_range_scan(const RangeScan& /*scan*/) override {
    poses_before_scans.push_back(T_odom_robots.size());
  }
  void on_hazards(const sensors::HazardObservation& observation) override { hazards = observation; }
  void on_landmark(const sensors::LandmarkObservation& observation) override {
    landmarks.push_back(observation.id);
  }

  std::vector<double> stamps_s;
  std::vector<Pose2> fixes;
  std::vector<std::size_t> poses_before_scans;
  sensors::HazardObservation hazards;
  std::vector<std::int64_t> landmarks;
};

void expect_near(const Pose2& pose, const Pose2& wanted) {
  EXPECT_NEAR(pose.x_m(), wanted.x_m(), 1e-12);
  EXPECT_NEAR(pose.y_m(), wanted.y_m(), 1e-12);
  EXPECT_NEAR(pose.heading_rad(), wanted.heading_rad(), 1e-12);
}

TEST(LogPlayer, TellsEveryKindOfOdometryAsPoses) {
  Listener listener;
  const LogCounts counts = tests::play({OdometryStep{{}, {1.0, 0.0, kRightAngleRad}},
                                        WheelIncrement{{}, 0.5, 0.5, 0.2},
                                        OdometryPose{{}, {7.0, 8.0, 0.0}},
                                        GivenPose{{}, {1.0, 1.0, 1.0}}},
                                       listener);
  ASSERT_EQ(listener.T_odom_robots.size(), 3U);
  expect_near(listener.T_odom_robots[1], {1.0, 0.5, kRightAngleRad});
  expect_near(listener.T_odom_robots[2], {7.0, 8.0, 0.0});
  EXPECT_TRUE(listener.fixes.empty()) << "the log's own poses do not count";
  EXPECT_EQ(counts.odometry_poses, 3U);
  EXPECT_EQ(counts.given_poses, 1U);
  EXPECT_EQ(counts.poses_without_stamp, 3U);
}

TEST(LogPlayer, WheelsAloneTurnByTheirDifferenceAndAGyroKnowsBetter) {
  Listener wheels;
  tests::play({WheelIncrement{{}, -0.1, 0.1, 0.2}}, wheels);
  EXPECT_NEAR(wheels.T_odom_robots.back().heading_rad(), 1.0, 1e-12);

  Listener gyro;
  tests::play({Heading{{}, 3.0},
               WheelIncrement{{}, 0.0, 0.0, 0.2},
               Heading{{}, -3.0},
               WheelIncrement{{}, -0.1, 0.1, 0.2}},
              gyro);
  EXPECT_NEAR(gyro.T_odom_robots.back().heading_rad(), 2.0 * std::numbers::pi - 6.0, 1e-12);
}

TEST(LogPlayer, WhereGivenPosesCountEachIsAFixOfTheOdometry) {
  Listener listener;
  const LogCounts counts = tests::play({OdometryStep{0.5, {5.0, 0.0, 0.0}},
                                        RangeScan{},
                                        LandmarkSighting{},
                                        GivenPose{1.0, {1.0, 1.0, kRightAngleRad}},
                                        RangeScan{},
                                        OdometryStep{2.0, {0.5, 0.0, 0.0}},
                                        GivenPose{2.0, {1.0, 1.5, kRightAngleRad}}},
                                       listener,
                                       PoseSource::kGiven);
  EXPECT_EQ(counts.scans, 2U);
  EXPECT_EQ(counts.scans_without_pose, 1U);
  EXPECT_EQ(counts.sightings_without_pose, 1U);
  EXPECT_EQ(listener.fixes.size(), 2U);
  EXPECT_THAT(listener.stamps_s, ElementsAre(1.0, 2.0)) << "one pose an instant";
  EXPECT_THAT(listener.poses_before_scans, ElementsAre(1U));
}

TEST(LogPlayer, BeginsAtTheOriginForSlamAndTellsWhereThatIs) {
  Listener listener;
  tests::play(
      {RangeScan{}, OdometryPose{1.0, {5e6, 0.0, 0.0}}, OdometryPose{2.0, {5e6 + 1.0, 0.0, 0.0}}},
      listener,
      PoseSource::kOdometryFromOrigin);
  ASSERT_EQ(listener.T_odom_robots.size(), 3U);
  expect_near(listener.T_odom_robots[0], {});
  expect_near(listener.T_odom_robots[1], {});
  expect_near(listener.T_odom_robots[2], {1.0, 0.0, 0.0});
  ASSERT_EQ(listener.fixes.size(), 1U);
  expect_near(listener.fixes[0], {5e6, 0.0, 0.0});
}

TEST(LogPlayer, TheFirstStepIsDrivenAfterTheScansBeforeIt) {
  Listener listener;
  tests::play({RangeScan{}, OdometryStep{{}, {0.5, 0.0, 0.0}}, RangeScan{}},
              listener,
              PoseSource::kOdometryFromOrigin);
  EXPECT_THAT(listener.poses_before_scans, ElementsAre(1U, 2U));
  EXPECT_DOUBLE_EQ(listener.T_odom_robots[1].x_m(), 0.5);
}

TEST(LogPlayer, TellsOfContactsAndLandmarks) {
  Listener listener;
  const Contact left{1.0, true, false, 0.17};
  const LogCounts counts = tests::play(
      {left, left, Contact{2.0, false, false, 0.17}, left, LandmarkSighting{3.0, 7, 2.0, 0.0}},
      listener);
  EXPECT_TRUE(listener.hazards.bump_left);
  EXPECT_FALSE(listener.hazards.bump_right);
  EXPECT_EQ(listener.hazards.bumper_radius_m, 0.17);
  EXPECT_EQ(counts.bumps, 2U) << "a bumper that stays pressed is one bump";
  EXPECT_THAT(listener.landmarks, ElementsAre(7));
}

TEST(LogPlayer, TheStampsOfOdometryRiseWhateverTheLogDoes) {
  Listener listener;
  std::vector<datasets::LogRecord> records;
  for (const std::optional<double> stamp_s : {std::optional(10.0),
                                              std::optional<double>(),
                                              std::optional(9.0),
                                              std::optional(10.5),
                                              std::optional(10.5),
                                              std::optional(1e12)}) {
    records.emplace_back(OdometryPose{stamp_s, {}});
  }
  const LogCounts counts = tests::play(records, listener);
  const std::vector<double> rising_s{10.0, 10.001, 10.001001, 10.5, 10.500001, 10.501001};
  EXPECT_THAT(listener.stamps_s, Pointwise(DoubleNear(1e-8), rising_s));
  EXPECT_EQ(counts.poses_without_stamp, 2U) << "one has none, the other is beyond the year 5000";
}

TEST(LogPlayer, ALogLastsFromItsFirstStampToItsLast) {
  Listener listener;
  LogPlayer player(listener);
  EXPECT_FALSE(player.duration_s());
  player.play(OdometryPose{12.0, {}});
  player.play(OdometryPose{std::nullopt, {}});
  player.play(OdometryPose{15.5, {}});
  EXPECT_EQ(player.duration_s(), 3.5);
}

}  // namespace
}  // namespace echomap::pipeline
