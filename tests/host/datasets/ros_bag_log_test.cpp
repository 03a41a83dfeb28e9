// SPDX-License-Identifier: MIT
#include "host/datasets/ros_bag_log.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/datasets/line_reader.hpp"
#include "host/datasets/open_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "tests/support/bag_writer.hpp"
#include "tests/support/fastcdr_messages.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using sensors::RangeScan;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::only;
using tests::ros_odometry;
using tests::ros_range;
using tests::ros_transform;

class RosBagLogTest : public testing::Test {
 protected:
  std::vector<LogRecord> records() {
    bag_.finish();
    return tests::records_of(*open_ros_bag_log(path_));
  }
  /// The records before the error, and its text.
  template <class Error>
  std::string error_behind(std::vector<LogRecord>& records) {
    const auto log = open_ros_bag_log(path_);
    return tests::thrown_text<Error>([&] {
      while (const auto record = log->next()) {
        // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
        records.push_back(*record);
      }
    });
  }

  tests::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "drive.mcap";
  tests::BagWriter bag_{path_};
};

/// Places of odometry along x, metres.
std::vector<double> places_m(const std::vector<LogRecord>& records) {
  std::vector<double> places_m;
  for (const OdometryPose& pose : only<OdometryPose>(records)) {
    places_m.push_back(pose.T_odom_robot.x_m());
  }
  return places_m;
}

TEST_F(RosBagLogTest, OdometryIsThePoseOfItsTopic) {
  bag_.write("/odom", ros_odometry(12.5, {1.0, 2.0, radians(30.0)}), 12.6);
  bag_.write("/tf", ros_transform(12.5, "odom", "base_link", {9.0, 9.0, 0.0}), 12.6);
  const auto poses = only<OdometryPose>(records());
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].stamp_s, 12.5);
  EXPECT_EQ(poses[0].T_odom_robot.position_m(), Eigen::Vector2d(1.0, 2.0));
  EXPECT_NEAR(poses[0].T_odom_robot.heading_rad(), radians(30.0), 1e-12);
}

TEST_F(RosBagLogTest, WithoutThatTopicOdometryIsTheTransform) {
  bag_.write("/tf", ros_transform(1.0, "odom", "base_footprint", {0.5, 0.0, 0.0}), 1.0);
  bag_.write("/tf", ros_transform(1.0, "map", "odom", {7.0, 0.0, 0.0}), 1.0);
  bag_.write("/tf", ros_transform(1.1, "odom", "base_footprint", {0.6, 0.0, 0.0}), 1.1);
  EXPECT_THAT(places_m(records()), ElementsAre(0.5, 0.6));
}

TEST_F(RosBagLogTest, EveryRangeTopicIsASensorWhereTransformsPutIt) {
  bag_.write("/tf_static", ros_transform(0.0, "base_link", "left", {0.0, 0.1, radians(90.0)}), 1.0);
  bag_.write("/tf_static", ros_transform(0.0, "base_link", "mast", {0.2, 0.0, 0.0}), 1.0);
  bag_.write("/tf_static", ros_transform(0.0, "mast", "front", {0.1, 0.0, 0.0}), 1.0);
  bag_.write("/sonar_left", ros_range(2.0, "left", 1.5), 2.0);
  bag_.write("/sonar_front", ros_range(2.1, "front", 0.5), 2.1);
  const auto scans = only<RangeScan>(records());
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].T_robot_sensor.y_m(), 0.1);
  EXPECT_NEAR(scans[0].T_robot_sensor.heading_rad(), radians(90.0), 1e-12);
  EXPECT_EQ(scans[0].beams, (std::vector<sensors::Beam>{{0.0, 1.5}}));
  EXPECT_NEAR(scans[1].T_robot_sensor.x_m(), 0.3, 1e-12);
  EXPECT_EQ(scans[1].stamp_s, 2.1);
}

TEST_F(RosBagLogTest, APannedSensorIsWhereItLookedAtTheMoment) {
  bag_.write("/tf", ros_transform(1.0, "base_link", "pan", {0.0, 0.0, radians(-40.0)}), 1.0);
  bag_.write("/sonar", ros_range(1.25, "pan", 1.0), 1.25);
  bag_.write("/tf", ros_transform(1.5, "base_link", "pan", {0.0, 0.0, radians(40.0)}), 1.5);
  const auto scans = only<RangeScan>(records());
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_NEAR(scans[0].T_robot_sensor.heading_rad(), 0.0, 1e-9);
}

TEST_F(RosBagLogTest, ALaserIsAScanOfAllItsBeams) {
  ros_messages::LaserScan sweep;
  sweep.header = tests::ros_header(3.0, "laser");
  sweep.angle_min = -1.0F;
  sweep.angle_increment = 0.5F;
  sweep.range_max = 10.0F;
  sweep.ranges = {1.0F, 2.0F, std::numeric_limits<float>::infinity(), 4.0F, 5.0F};
  bag_.write(
      "/tf_static", ros_transform(0.0, "base_link", "laser", {0.1, 0.0, radians(90.0)}), 1.0);
  bag_.write("/scan", sweep, 3.1);
  bag_.write("/scan_filtered", sweep, 3.1);
  const auto scans = only<RangeScan>(records());
  ASSERT_EQ(scans.size(), 1U);
  ASSERT_EQ(scans[0].beams.size(), 5U);
  EXPECT_EQ(scans[0].beams[1], (sensors::Beam{-0.5, 2.0}));
  EXPECT_EQ(scans[0].beams[2].range_m, std::nullopt);
  EXPECT_EQ(scans[0].T_robot_sensor.x_m(), 0.1);
}

TEST_F(RosBagLogTest, RecordsComeInTheOrderOfTheirStamps) {
  // The laser's message comes when its sweep has ended.
  bag_.write("/odom", ros_odometry(1.0, {0.1, 0.0, 0.0}), 1.01);
  bag_.write("/odom", ros_odometry(1.1, {0.2, 0.0, 0.0}), 1.11);
  bag_.write("/sonar", ros_range(1.05, "base_link", 1.0), 1.2);
  bag_.write("/odom", ros_odometry(1.2, {0.3, 0.0, 0.0}), 1.21);
  const auto all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(stamp_s(all[1]), 1.05);
  EXPECT_TRUE(std::holds_alternative<RangeScan>(all[1]));
  EXPECT_EQ(stamp_s(all[3]), 1.2);
}

TEST_F(RosBagLogTest, WhatComesMuchTooLateStaysBehindAndHasNoStamp) {
  bag_.write("/odom", ros_odometry(1.0, {0.1, 0.0, 0.0}), 1.0);
  bag_.write("/odom", ros_odometry(2.0, {0.2, 0.0, 0.0}), 2.0);
  bag_.write("/odom", ros_odometry(3.0, {0.3, 0.0, 0.0}), 3.0);
  bag_.write("/odom", ros_odometry(1.5, {0.4, 0.0, 0.0}), 3.1);
  const auto all = records();
  EXPECT_THAT(places_m(all), ElementsAre(0.1, 0.2, 0.4, 0.3));
  EXPECT_EQ(stamp_s(all[2]), std::nullopt);
}

TEST_F(RosBagLogTest, AHeaderWithoutAStampHasThatOfTheRecorder) {
  bag_.write("/odom", ros_odometry(0.0, {0.1, 0.0, 0.0}), 5.5);
  EXPECT_EQ(stamp_s(records().at(0)), 5.5);
}

TEST_F(RosBagLogTest, ReadsWhatFastcdrWrites) {
  const auto put = [this](const std::string& topic, const auto& message, double time_s) {
    using M = std::decay_t<decltype(message)>;
    bag_.write_bytes(topic, std::string(M::kName), tests::fastcdr_bytes(message), time_s);
  };
  put("/tf_static", ros_transform(0.0, "base_link", "sonar_link", {0.1, 0.0, 0.0}), 1.0);
  put("/odom", ros_odometry(1.0, {0.5, 0.0, radians(10.0)}), 1.0);
  put("/sonar", ros_range(1.1, "sonar_link", 2.5), 1.1);
  ros_messages::LaserScan sweep;
  sweep.header = tests::ros_header(1.2, "base_link");
  sweep.range_max = 10.0F;
  sweep.ranges = {3.5F};
  put("/scan", sweep, 1.2);
  const auto all = records();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(std::get<OdometryPose>(all[0]).T_odom_robot.heading_rad(), radians(10.0), 1e-12);
  EXPECT_EQ(std::get<RangeScan>(all[1]).beams.at(0).range_m, 2.5);
  EXPECT_EQ(std::get<RangeScan>(all[1]).T_robot_sensor.x_m(), 0.1);
  EXPECT_EQ(std::get<RangeScan>(all[2]).beams.at(0).range_m, 3.5);
}

TEST_F(RosBagLogTest, ABagThatIsCutOffHasItsRecordsBeforeTheError) {
  for (int i = 0; i < 20; ++i) {
    bag_.write("/odom", ros_odometry(1.0 + i, {0.1 * i, 0.0, 0.0}), 1.0 + i);
    bag_.flush();
  }
  // As a recorder leaves it that was killed.
  const auto bytes = std::filesystem::file_size(path_);
  std::filesystem::copy_file(path_, folder_ / "killed.mcap");
  bag_.finish();
  path_ = folder_ / "killed.mcap";
  std::filesystem::resize_file(path_, bytes - 300);
  std::vector<LogRecord> before;
  EXPECT_THAT(error_behind<CutOffLine>(before), HasSubstr("killed.mcap"));
  EXPECT_EQ(before.size(), 19U);
}

TEST_F(RosBagLogTest, ADamagedMessageIsAnErrorBehindWhatIsBeforeIt) {
  const std::vector<std::uint8_t> half{0, 1, 0, 0, 1, 0, 0, 0};
  bag_.write("/odom", ros_odometry(1.0, {}), 1.0);
  bag_.write_bytes("/odom", std::string(ros_messages::Odometry::kName), half, 1.1);
  bag_.write("/odom", ros_odometry(1.2, {}), 1.2);
  bag_.finish();
  std::vector<LogRecord> before;
  EXPECT_THAT(error_behind<files::FileError>(before),
              AllOf(HasSubstr("drive.mcap: message 1 of /odom: nav_msgs/msg/Odometry"),
                    HasSubstr("ends after 4 bytes")));
  EXPECT_EQ(before.size(), 1U);
}

TEST_F(RosBagLogTest, AnOrientationThatIsNoneIsAnError) {
  auto odometry = ros_odometry(1.0, {});
  odometry.pose.pose.orientation.w = 0.0;
  bag_.write("/odom", odometry, 1.0);
  bag_.finish();
  std::vector<LogRecord> before;
  EXPECT_THAT(error_behind<files::FileError>(before),
              HasSubstr("message 0 of /odom: the quaternion of the orientation has length"));
}

TEST_F(RosBagLogTest, ScansBeforeTheFirstTransformToTheirSensorAreLeftOut) {
  bag_.write("/sonar", ros_range(1.0, "pan", 1.0), 1.0);
  bag_.write("/tf", ros_transform(3.0, "base_link", "pan", {}), 3.0);
  bag_.write("/sonar", ros_range(3.1, "pan", 2.0), 3.1);
  const auto scans = only<RangeScan>(records());
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(scans[0].beams.at(0).range_m, 2.0);
}

TEST_F(RosBagLogTest, NotesWhatIsNotUsed) {
  bag_.write("/odom", ros_odometry(1.0, {}), 1.0);
  bag_.write("/filtered", ros_odometry(1.0, {}), 1.0);
  bag_.finish();
  EXPECT_THAT(open_ros_bag_log(path_)->notes(), ElementsAre(HasSubstr("/filtered is ignored")));
}

TEST_F(RosBagLogTest, IsRecognisedByItsNameOrItsFolder) {
  bag_.finish();
  EXPECT_EQ(recognised_format(path_), "ros2-bag");
  EXPECT_EQ(recognised_format(folder_.path()), std::nullopt);
  files::write_text_file(folder_ / "metadata.yaml", "");
  EXPECT_EQ(recognised_format(folder_.path()), "ros2-bag");
}

TEST_F(RosBagLogTest, AFolderIsReadAsOneBag) {
  bag_.write("/odom", ros_odometry(1.0, {0.1, 0.0, 0.0}), 1.0);
  bag_.finish();
  tests::BagWriter second(folder_ / "drive_1.mcap");
  second.write("/odom", ros_odometry(2.0, {0.2, 0.0, 0.0}), 2.0);
  second.finish();
  EXPECT_THAT(places_m(tests::records_of(*open_ros_bag_log(folder_.path()))),
              ElementsAre(0.1, 0.2));
}

/// A message of which some bytes are anything.
template <ros_messages::Message M>
std::vector<std::uint8_t> damaged_bytes(const M& message, std::mt19937& random) {
  std::vector<std::uint8_t> bytes = ros_messages::serialize(message);
  for (auto faults = random() % 4; faults > 0; --faults) {
    bytes[4 + random() % (bytes.size() - 4)] = static_cast<std::uint8_t>(random());
  }
  return bytes;
}

/// A bag of each type of message, all of them damaged.
void write_damaged_bag(const std::filesystem::path& path, std::mt19937& random) {
  tests::BagWriter bag(path);
  const auto put = [&](const std::string& topic, const auto& message, double time_s) {
    using M = std::decay_t<decltype(message)>;
    bag.write_bytes(topic, std::string(M::kName), damaged_bytes(message, random), time_s);
  };
  ros_messages::LaserScan sweep;
  sweep.header = tests::ros_header(1.2, "mast");
  sweep.range_max = 8.0F;
  sweep.ranges.assign(20, 1.0F);
  for (double time_s = 1.0; time_s < 3.0; time_s += 0.25) {
    put("/tf_static", ros_transform(0.0, "base_link", "mast", {0.1, 0.0, 0.5}), time_s);
    put("/tf", ros_transform(time_s, "mast", "sonar", {0.0, 0.0, -0.5}), time_s);
    put("/odom", ros_odometry(time_s, {0.1, 0.2, 0.3}), time_s);
    put("/sonar", ros_range(time_s, "sonar", 2.0), time_s);
    put("/scan", sweep, time_s);
  }
  bag.finish();
}

TEST_F(RosBagLogTest, DamagedMessagesAreRecordsOfFiniteNumbersOrAnError) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    write_damaged_bag(folder_ / "damaged.mcap", random);
    try {
      const auto log = open_ros_bag_log(folder_ / "damaged.mcap");
      while (const auto record = log->next()) {
        // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
        if (const auto* scan = std::get_if<RangeScan>(&*record)) {
          ASSERT_TRUE(std::isfinite(scan->T_robot_sensor.x_m()));
          ASSERT_TRUE(std::isfinite(scan->T_robot_sensor.heading_rad()));
          ASSERT_GT(scan->max_range_m, 0.0);
          // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
        } else if (const auto* pose = std::get_if<OdometryPose>(&*record)) {
          ASSERT_TRUE(std::isfinite(pose->T_odom_robot.x_m() + pose->T_odom_robot.heading_rad()));
        }
      }
    } catch (const files::FileError& error) {
      ASSERT_THAT(error.what(), HasSubstr("damaged.mcap: "));
    }
  }
}

}  // namespace
}  // namespace echomap::datasets
