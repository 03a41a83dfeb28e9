// SPDX-License-Identifier: MIT
#include "host/exports/carmen_log.hpp"

#include <cstdlib>
#include <stdexcept>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/datasets/open_log.hpp"
#include "host/exports/sweep_times.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/support/panned_stops.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// What datasets::open_log reads of a CARMEN log.
struct ReadLog {
  std::vector<datasets::OdometryPose> poses;
  std::vector<sensors::RangeScan> scans;
  std::vector<geometry::Pose2> T_map_robots;  ///< Of the scans.
};

ReadLog read_log(const std::filesystem::path& path) {
  ReadLog log;
  const auto reader = datasets::open_log(path, "carmen");
  while (const auto record = reader->next()) {
    if (const auto* pose = std::get_if<datasets::OdometryPose>(&*record)) {
      log.poses.push_back(*pose);
    } else if (const auto* given = std::get_if<datasets::GivenPose>(&*record)) {
      log.T_map_robots.push_back(given->T_map_robot);
    } else if (const auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      log.scans.push_back(*scan);
    }
  }
  return log;
}

/// A run whose second stop has a silent reading, and one without an answer.
pipeline::Snapshot run_with_silence() {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  std::vector<mapping::Scan> scans = *snapshot.scans;
  scans[1][4].range_m.reset();
  scans[1][5].range_m.reset();
  scans[1][5].has_answered = false;
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(scans);
  return snapshot;
}

class CarmenLogTest : public ::testing::Test {
 protected:
  ReadLog written(const pipeline::Snapshot& snapshot, const CarmenLogParams& params = {}) {
    write_carmen_log(folder / "run.carmen", snapshot, params);
    return read_log(folder / "run.carmen");
  }
  std::string text() const { return files::read_text_file(folder / "run.carmen"); }

  tests::ScratchFolder folder;
};

TEST_F(CarmenLogTest, ReadsBackTheTrajectory) {
  const pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const ReadLog log = written(snapshot);
  // Every scan brings a pose of its own.
  ASSERT_EQ(log.poses.size(), snapshot.trajectory->size() + log.scans.size());
  EXPECT_EQ(log.poses.front().stamp_s, 0.0);
  EXPECT_EQ(log.poses.back().T_odom_robot.position_m(), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(log.poses[50].stamp_s, 5.0);
}

TEST_F(CarmenLogTest, ReadsBackEveryEchoOfTheStops) {
  const pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const ReadLog log = written(snapshot);
  ASSERT_EQ(log.scans.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const mapping::Scan& scan = snapshot.scans->at(i);
    ASSERT_EQ(log.scans[i].beams.size(), scan.size());
    for (std::size_t j = 0; j < scan.size(); ++j) {
      const sensors::Beam& beam = log.scans[i].beams[j];
      const Eigen::Vector2d in_sensor_m =
          beam.range_m.value_or(0.0) * geometry::unit_vector(beam.bearing_rad);
      const Eigen::Vector2d echo_m =
          log.T_map_robots[i] * (log.scans[i].T_robot_sensor * in_sensor_m);
      EXPECT_LT((echo_m - mapping::echo_point_m(scan[j]).value()).norm(), 1e-4) << i << ", " << j;
    }
  }
}

TEST_F(CarmenLogTest, HasSweepsWhenTheyWereComplete) {
  const ReadLog log = written(tests::run_of_two_stops());
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.scans[0].stamp_s, 10.1);
  EXPECT_EQ(log.scans[1].stamp_s, 30.0);
}

TEST_F(CarmenLogTest, TellsSilenceByTheMaximumRangeAndNoAnswerByZero) {
  const ReadLog log = written(run_with_silence(), {.max_range_m = 2.5});
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.scans[1].max_range_m, 2.5);
  EXPECT_EQ(log.scans[1].beams[4].range_m, std::nullopt);
  EXPECT_EQ(log.scans[1].beams[5].range_m, std::nullopt);
  EXPECT_THAT(text(), HasSubstr(" 0.8030 2.5000 0.0000 0.8060 "));
  EXPECT_THAT(text(), HasSubstr("PARAM robot_front_laser_max 2.5000 "));
}

TEST_F(CarmenLogTest, LosesNoEchoBeyondTheMaximumRange) {
  const ReadLog log = written(run_with_silence(), {.max_range_m = 0.6});
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_NEAR(log.scans[1].beams.back().range_m.value_or(0.0), 0.818, 1e-9);
  EXPECT_EQ(log.scans[1].beams[4].range_m, std::nullopt);
}

TEST_F(CarmenLogTest, HasTheFieldsOfTheFormat) {
  pipeline::Snapshot snapshot = tests::snapshot_of(
      mapping::OccupancyGrid(), {tests::pose_at(1.0, {}), tests::pose_at(1.5, {0.1, 0.0, 0.2})});
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(std::vector<mapping::Scan>{
      {{{}, {0.0, 0.0, -0.25}, 0.5}, {{}, {}, 0.75}, {{}, {0.0, 0.0, 0.25}, 1.0}}});
  written(snapshot);
  EXPECT_THAT(text(),
              HasSubstr("PARAM robot_frontlaser_offset 0.0000 0 echomap 0\n"
                        "PARAM robot_front_laser_max 4.0000 0 echomap 0\n"
                        "PARAM laser_front_laser_resolution 14.3239 0 echomap 0\n"
                        "ODOM 0.000000 0.000000 0.000000000 0.000000 0.000000 0.000000 1.000000 "
                        "echomap 0.000000\n"
                        "ODOM 0.100000 0.000000 0.200000000 0.200000 0.400000 0.000000 1.500000 "
                        "echomap 0.500000\n"
                        "ROBOTLASER1 99 -0.250000000 0.500000000 0.250000000 4.0000 0.0300 0 3 "
                        "0.5000 0.7500 1.0000 0 0.000000 0.000000 0.000000000 0.000000 0.000000 "
                        "0.000000000 0 0 0 0 0 1.500000 echomap 0.500000\n"));
}

TEST_F(CarmenLogTest, HasNoSpeedWhereSomebodyHasCarriedTheRobot) {
  pipeline::Snapshot snapshot = tests::snapshot_of(
      mapping::OccupancyGrid(), {tests::pose_at(1.0, {}), tests::pose_at(1.5, {3.0, 0.0, 0.2})});
  snapshot.carried_to = {1};
  written(snapshot);
  EXPECT_THAT(text(), HasSubstr("ODOM 3.000000 0.000000 0.200000000 0.000000 0.000000 "));
}

TEST_F(CarmenLogTest, OfNothingHasOnlyParameters) {
  EXPECT_TRUE(written(tests::snapshot_of(mapping::OccupancyGrid())).poses.empty());
  EXPECT_THAT(text(), HasSubstr("PARAM"));
}

TEST_F(CarmenLogTest, RefusesParametersOutOfRange) {
  const auto snapshot = tests::run_of_two_stops();
  EXPECT_THROW(written(snapshot, {.max_range_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(written(snapshot, {.range_stddev_m = -1.0}), std::invalid_argument);
}

TEST_F(CarmenLogTest, IsReadByMrptWhereThatIsInstalled) {
  const std::string reader = ECHOMAP_CARMEN_TO_RAWLOG;
  if (reader.empty() || reader.ends_with("NOTFOUND")) {
    GTEST_SKIP() << "carmen2rawlog of Debian's mrpt-apps is not installed";
  }
  write_carmen_log(folder / "run.carmen", run_with_silence());
  const std::string rawlog = (folder / "run.rawlog").string();
  const std::string said = " >> " + (folder / "said").string() + " 2>&1";
  const std::string convert =
      reader + " -q -w -i " + (folder / "run.carmen").string() + " -o " + rawlog + said;
  const std::string describe =
      (std::filesystem::path(reader).parent_path() / "rawlog-edit").string() + " --info -q -i " +
      rawlog + said;
  EXPECT_EQ(std::system((convert + " && " + describe).c_str()), 0);
  EXPECT_THAT(files::read_text_file(folder / "said"), ContainsRegex("ROBOTLASER1 / +2 /"));
}

}  // namespace
}  // namespace echomap::exports
