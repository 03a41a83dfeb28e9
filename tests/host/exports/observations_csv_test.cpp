// SPDX-License-Identifier: MIT
#include "host/exports/observations_csv.hpp"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/slam/slam_methods.hpp"
#include "tests/support/robot_times.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;
using tests::at_us;

std::unique_ptr<pipeline::RobotPipeline> new_pipeline() {
  sensors::RobotGeometry robot;
  robot.track_m = 0.2;
  mapping::ContactMapperParams near;
  near.T_robot_infrared = {{0.1, 0.0, 0.0}, {0.0, 0.1, 1.5}};
  near.infrared_reach_m = 0.3;
  return std::make_unique<pipeline::RobotPipeline>(
      robot, mapping::SonarMapperParams{}, near, slam::slam_by_name("multiscan").make());
}

/// A robot that goes round in circles with all its sensors, and what it hears.
void drive(pipeline::ObservationSink& sink, int stops) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  std::int64_t stamp_us = 12345;
  sensors::WheelTravel travel;
  for (int stop = 0; stop < stops; ++stop) {
    for (int i = 0; i < 20; ++i) {
      travel.left_m += 0.005 + noise(random);
      travel.right_m += 0.015 + noise(random);
      sink.on_odometry({at_us(stamp_us += 20'000), travel});
      sink.on_infrared({at_us(stamp_us), travel, {std::nullopt, 0.2 + noise(random)}});
    }
    sink.on_hazards({.stamp = at_us(stamp_us), .bump_left = stop == 1, .wall = stop == 0});
    sink.begin_scan();
    for (int pan_deg = -90; pan_deg < 90; pan_deg += 3) {
      const auto range_m = pan_deg % 5 == 0 ? std::nullopt : std::optional(1.0 + noise(random));
      sink.on_sonar({at_us(stamp_us += 40'000), travel, 0.01745 * pan_deg, range_m});
    }
    sink.end_scan();
  }
}

/// All that is on disk of a pipeline, in one text.
std::string files_of(const pipeline::RobotPipeline& pipeline,
                     const std::filesystem::path& directory) {
  write_run_directory(directory, pipeline.snapshot(), {});
  write_pose_graph_g2o(directory / "pose_graph.g2o", pipeline.slam()->factor_graph());
  std::string text;
  for (const char* name : {"points.csv", "poses.csv", "occupancy_grid.csv", "pose_graph.g2o"}) {
    text += files::read_text_file(directory / name);
  }
  return text;
}

TEST(ObservationsCsv, APipelineThatTakesARecordIsTheSameToTheLastBit) {
  const tests::ScratchFolder scratch;
  const auto live = new_pipeline();
  ObservationRecorder recorder;
  pipeline::ObservationFork fork;
  fork.add(recorder);
  fork.add(*live);
  drive(fork, 4);
  recorder.save(scratch / "observations.csv");

  const auto replayed = new_pipeline();
  ObservationRecorder again;
  pipeline::ObservationFork second_fork;
  second_fork.add(again);
  second_fork.add(*replayed);
  replay_observations_csv(scratch / "observations.csv", second_fork);
  again.save(scratch / "again.csv");

  EXPECT_EQ(files_of(*live, scratch / "live"), files_of(*replayed, scratch / "replayed"));
  EXPECT_EQ(files::read_text_file(scratch / "observations.csv"),
            files::read_text_file(scratch / "again.csv"));
  const auto& expected = *live->snapshot().trajectory;
  const auto& trajectory = *replayed->snapshot().trajectory;
  ASSERT_EQ(trajectory.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(trajectory[i].stamp, expected[i].stamp);
    EXPECT_EQ(trajectory[i].T_map_robot.position_m(), expected[i].T_map_robot.position_m());
    EXPECT_EQ(trajectory[i].T_map_robot.heading_rad(), expected[i].T_map_robot.heading_rad());
  }
  EXPECT_EQ(replayed->snapshot().stops, 4U);
}

TEST(ObservationsCsv, IsAsItsDocumentSays) {
  const tests::ScratchFolder scratch;
  ObservationRecorder recorder;
  recorder.begin_scan();
  recorder.on_odometry({at_us(5), {0.1, -0.25}});
  recorder.on_sonar({at_us(6), {0.1, 1e-9}, -1.5, std::nullopt});
  recorder.on_sonar({at_us(7), {0.1, 0.2}, 0.0, 2.0});
  recorder.on_sonar({at_us(7), {0.1, 0.2}, 0.0, std::nullopt, false});
  recorder.on_infrared({at_us(8), {0.1, 0.2}, {0.5, std::nullopt}});
  recorder.on_hazards({.stamp = at_us(9), .bump_right = true, .cliffs = {true}, .lifted = true});
  recorder.on_battery({at_us(10), 7.0});
  recorder.end_scan();
  recorder.on_carried({at_us(11), {0.1, 0.2}, {1.5, -2.0, 0.25}});
  recorder.on_pose_fix({at_us(12), {1.25, -2.0, 0.5}});
  recorder.save(scratch / "record");
  EXPECT_EQ(files::read_text_file(scratch / "record"),
            "kind,stamp_us,values\n"
            "begin-scan\n"
            "odometry,5,0.1,-0.25\n"
            "sonar,6,0.1,1e-09,-1.5,none\n"
            "sonar,7,0.1,0.2,0,2\n"
            "sonar,7,0.1,0.2,0,silent\n"
            "infrared,8,0.1,0.2,0.5,none\n"
            "hazards,9,0,1,1,0,0,0,1,0,0\n"
            "end-scan\n"
            "carried,11,0.1,0.2,1.5,-2,0.25\n"
            "fix,12,1.25,-2,0.5\n");
  ObservationRecorder again;
  EXPECT_FALSE(replay_observations_csv(scratch / "record", again));
  EXPECT_EQ(again.lines(), recorder.lines());
}

TEST(ObservationsCsv, SaysWhichLineIsDamagedAndWhy) {
  const tests::ScratchFolder scratch;
  const auto path = scratch / "record";
  const auto error_of = [&](const std::string& line) {
    files::write_text_file(path, "kind,stamp_us,values\nodometry,1,0,0\n" + line + "\n");
    ObservationRecorder sink;
    return tests::thrown_text<files::FileError>([&] { replay_observations_csv(path, sink); });
  };
  for (const auto& [line, why] : std::initializer_list<std::pair<const char*, const char*>>{
           {"odometri,2,0,0", "the kind is 'odometri', not an observation that a run records"},
           {"odometry,2,0", "the right wheel is missing"},
           {"odometry,2,0,0,0", "'0' follows"},
           {"odometry,2.5,0,0", "the stamp is '2.5', not a whole number"},
           {"odometry,900000000000000000,0,0", "outside the range of microseconds"},
           {"odometry,2,0,nan", "the right wheel is 'nan', not a finite number"},
           {"odometry,2,0,101", "more than 100 m since the line before"},
           {"sonar,2,0,0,0.1", "the range is missing"},
           {"sonar,2,0,0,0.1,nothing", "the range is 'nothing'"},
           {"sonar,2,0,0,0.1,1001", "longer than a sensor reaches"},
           {"infrared,2,0,0,0.1,", "the range is missing"},
           {"hazards,2,0,0,0,0,0,0,2,0,0", "neither 0 nor 1"},
           {"begin-scan,1", "'1' follows"},
           {"", "the kind is missing"}}) {
    EXPECT_THAT(error_of(line), HasSubstr(path.string() + ":3: ")) << line;
    EXPECT_THAT(error_of(line), HasSubstr(why)) << line;
  }
}

TEST(ObservationsCsv, LeavesOutALastLineWithoutEnd) {
  const tests::ScratchFolder scratch;
  const auto path = scratch / "record";
  const std::string whole = "kind,stamp_us,values\nodometry,1,0,0\n";
  for (const std::string& rest : {std::string("odometry,2,0"),
                                  std::string("odometry,2,0,0.12"),
                                  std::string("no"),
                                  std::string(5000, '\0')}) {
    files::write_text_file(path, whole + rest);
    ObservationRecorder read;
    EXPECT_TRUE(replay_observations_csv(path, read)) << rest;
    EXPECT_EQ(read.lines(), "odometry,1,0,0\n") << rest;
  }
  ObservationRecorder read;
  files::write_text_file(path, whole);
  EXPECT_FALSE(replay_observations_csv(path, read));
  files::write_text_file(path, whole + "odometry,2,0\nodometry,3,0");
  EXPECT_THROW(replay_observations_csv(path, read), files::FileError) << "not the last line";
}

TEST(ObservationsCsv, NeedsItsHeader) {
  const tests::ScratchFolder scratch;
  const auto path = scratch / "record";
  ObservationRecorder sink;
  files::write_text_file(path, "x_m,y_m\n");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { replay_observations_csv(path, sink); }),
              HasSubstr(":1: expected the header"));
  EXPECT_THROW(replay_observations_csv(scratch / "none", sink), files::FileError);
}

}  // namespace
}  // namespace echomap::exports
