// SPDX-License-Identifier: MIT
#include "host/apps/replay_run.hpp"

#include <csignal>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/saved_map.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/exports/observations_file.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

class ReplayRunTest : public ::testing::Test {
 protected:
  ReplayRunTest() {
    options.log = scratch / "run";
    options.out = scratch / "again";
    options.force = true;  // Some tests replay twice.
    std::filesystem::create_directories(options.log);
    stop(1.0);
    stop(1.2);
    exports::ObservationsFile(options.log / kRecordName).save(atlas.record(), false);
    summary.robot = profile.name;
    summary.slam = "multiscan";
    save_map(atlas.pipeline(), profile, options.log, summary);
  }
  /// All round, in a room whose walls are about so far.
  void stop(double range_m) {
    travelled_m += 0.2 / 3.0;
    const sensors::WheelTravel travel{travelled_m, travelled_m};
    atlas.on_odometry({stamp += std::chrono::milliseconds(20), travel});
    atlas.begin_scan();
    for (int i = 0; i < 31; ++i) {
      atlas.on_sonar({stamp += std::chrono::milliseconds(50), travel, 0.1 * i - 1.5, range_m});
    }
    atlas.end_scan();
  }
  std::string text(const std::string& file) const {
    return files::read_text_file(options.out / file);
  }
  std::string live_text(const std::string& file) const {
    return files::read_text_file(options.log / file);
  }

  const tests::ScratchFolder scratch;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  pipeline::RobotAtlas atlas = session::atlas_for(profile, "multiscan");
  exports::RunSummary summary;
  time::RobotTime stamp;
  double travelled_m = 0.0;
  ReplayOptions options;
};

TEST_F(ReplayRunTest, WritesTheSameFiles) {
  ASSERT_TRUE(plays_observations(options));
  EXPECT_EQ(run_replay(options), console::ExitCode::kOk);
  for (const char* file : {"map.pgm",
                           "map.yaml",
                           "occupancy_grid.csv",
                           "points.csv",
                           "poses.csv",
                           "trajectory.tum",
                           "outline.geojson",
                           "pose_graph.g2o",
                           "observations.csv",
                           "robot.toml"}) {
    EXPECT_EQ(text(file), live_text(file)) << file;
  }
  const auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("robot"), "uno_2wd");
  EXPECT_EQ(report.at("replay").at("poses"), "multiscan");
  EXPECT_EQ(report.at("pose_stddev_m"),
            nlohmann::json::parse(live_text("summary.json"))["pose_stddev_m"]);
}

TEST_F(ReplayRunTest, MayHaveTheRunsOwnDirectoryOrThatOfAnotherRun) {
  std::filesystem::create_directories(previous_map_of(options.out, 1));
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_FALSE(exists(previous_map_of(options.out, 1))) << "a map of the run before";
  const std::string map = text("map.pgm");
  options.log = options.out;
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_EQ(text("map.pgm"), map);
  EXPECT_FALSE(exists(options.out / kPreviousRecordName));
}

TEST_F(ReplayRunTest, KeepsTheOutlineThatTheStrategyDrew) {
  exports::RunDrawing drawing;
  drawing.outline_m = {{0.1, 0.2}, {1.0, 0.3}, {0.7, 1.0}};
  save_map(atlas.pipeline(), profile, options.log, summary, drawing);
  EXPECT_EQ(run_replay(options), console::ExitCode::kOk);
  EXPECT_EQ(text("outline.geojson"), live_text("outline.geojson"));
  EXPECT_EQ(text("map.svg"), live_text("map.svg"));
}

TEST_F(ReplayRunTest, IsNotForWhatAsksForAnotherMap) {
  const auto with = [&](auto member, const auto& value) {
    ReplayOptions other = options;
    other.*member = value;
    return plays_observations(other);
  };
  EXPECT_TRUE(with(&ReplayOptions::slam, "ekf"));
  EXPECT_FALSE(with(&ReplayOptions::slam, "scan"));
  EXPECT_FALSE(with(&ReplayOptions::poses, "given"));
  EXPECT_FALSE(with(&ReplayOptions::map, "points"));
  EXPECT_FALSE(with(&ReplayOptions::resolution_m, 0.1));
  EXPECT_FALSE(with(&ReplayOptions::log, options.log / "poses.csv"));
  std::filesystem::remove(options.log / kProfileName);
  EXPECT_FALSE(plays_observations(options)) << "as runs of older programs";
}

TEST_F(ReplayRunTest, PlacesTheRobotByAnotherSlamWhereOneIsNamed) {
  options.slam = "multiscan";
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_EQ(text("pose_graph.g2o"), live_text("pose_graph.g2o")) << "the run's own";
  options.slam = "ekf";
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_NE(text("pose_graph.g2o"), live_text("pose_graph.g2o"));
  EXPECT_EQ(text("observations.csv"), live_text("observations.csv"));
  const auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("slam"), "ekf");
  EXPECT_EQ(report.at("replay").at("poses"), "ekf");
}

TEST_F(ReplayRunTest, KeepsTheMapUpToWhereTheRecordIsDamaged) {
  const std::string record = live_text(kRecordName);
  files::write_text_file(options.log / kRecordName, record + "odometry,1\n");
  EXPECT_EQ(run_replay(options), console::ExitCode::kRuntimeError);
  EXPECT_EQ(text("map.pgm"), live_text("map.pgm"));
  EXPECT_EQ(nlohmann::json::parse(text("summary.json"))["outcome"], "log-damaged");
}

TEST_F(ReplayRunTest, KeepsTheOtherMapsWhereThatOfAPreviousOneLacksItsSummary) {
  for (const std::size_t number : {1U, 2U}) {
    std::filesystem::create_directories(previous_map_of(options.log, number));
    save_map(atlas.pipeline(), profile, previous_map_of(options.log, number), summary);
    std::filesystem::copy_file(options.log / kRecordName,
                               previous_map_of(options.log, number) / kRecordName);
  }
  std::filesystem::remove(previous_map_of(options.log, 1) / "summary.json");
  EXPECT_EQ(run_replay(options), console::ExitCode::kRuntimeError);
  EXPECT_FALSE(exists(previous_map_of(options.out, 1) / "map.pgm"));
  EXPECT_EQ(text("previous_2/map.pgm"), live_text("previous_2/map.pgm"));
  EXPECT_EQ(text("map.pgm"), live_text("map.pgm"));
}

TEST_F(ReplayRunTest, WritesNothingAfterCtrlC) {
  const auto replay_and_interrupt = [&] {
    console::catch_interrupts();
    std::raise(SIGINT);
    try {
      run_replay(options);
    } catch (const console::CommandError& error) {
      std::exit(static_cast<int>(error.code()));
    }
  };
  EXPECT_EXIT(replay_and_interrupt(), ::testing::ExitedWithCode(130), "");
  EXPECT_FALSE(exists(options.out));
}

TEST_F(ReplayRunTest, LeavesADamagedRunAsItIs) {
  const std::string damaged = live_text(kRecordName) + "odometry,1\n";
  files::write_text_file(options.log / kRecordName, damaged);
  options.out = options.log;
  EXPECT_EQ(run_replay(options), console::ExitCode::kRuntimeError);
  EXPECT_EQ(live_text(kRecordName), damaged);
}

TEST_F(ReplayRunTest, OfAnEmptyRecordIsAnError) {
  exports::ObservationsFile(options.log / kRecordName).save(pipeline::ObservationLog(), false);
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("the run has recorded nothing\n  next: "));
  EXPECT_FALSE(exists(options.out));
}

TEST_F(ReplayRunTest, NeedsTheSummaryOfARun) {
  files::write_text_file(options.log / "summary.json", "{}");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { run_replay(options); }),
              HasSubstr("summary.json: not the summary of a run"));
  EXPECT_FALSE(exists(options.out));
}

}  // namespace
}  // namespace echomap::apps
