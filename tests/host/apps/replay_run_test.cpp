// SPDX-License-Identifier: MIT
#include "host/apps/replay_run.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/saved_map.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/support/played_recording.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

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
    record({1.0, 1.2});
    summary.robot = profile.name;
    summary.slam = "multiscan";
    save_map(atlas.pipeline(), profile, options.log, summary);
  }
  /// The run has made stops whose walls are so far all round.
  void record(const std::vector<double>& ranges_m) {
    tests::WrittenRecording recording(profile);
    recording.begin(recorded);
    for (const double range_m : ranges_m) {
      recording.add_stop(range_m);
    }
    recording.save(recorded);
    tests::play_recording(recorded, atlas, &atlas);
  }
  /// Flips a bit in what was recorded of the second stop.
  void damage() const {
    std::string bytes = live_text("session.mcap");
    const std::size_t place = bytes.find("zstd", bytes.find("zstd") + 1) + 200;
    bytes[place] = static_cast<char>(bytes[place] ^ 1);
    files::write_text_file(recorded, bytes);
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
  ReplayOptions options;
  const std::filesystem::path recorded = scratch / "run" / recording::kSessionFileName;
};

TEST_F(ReplayRunTest, WritesTheSameFiles) {
  ASSERT_TRUE(plays_recording(options));
  EXPECT_EQ(run_replay(options), console::ExitCode::kOk);
  for (const char* file : {"map.pgm",
                           "map.yaml",
                           "occupancy_grid.csv",
                           "points.csv",
                           "poses.csv",
                           "trajectory.tum",
                           "outline.geojson",
                           "pose_graph.g2o",
                           "session.mcap",
                           "robot.toml"}) {
    EXPECT_EQ(text(file), live_text(file)) << file;
  }
  const auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("robot"), "uno_2wd");
  EXPECT_EQ(report.at("replay").at("poses"), "multiscan");
  EXPECT_EQ(report.at("replay").at("whole_recording"), true);
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
  EXPECT_FALSE(exists(options.out / kPreviousRecordingName));
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
    return plays_recording(other);
  };
  EXPECT_TRUE(with(&ReplayOptions::slam, "ekf"));
  EXPECT_FALSE(with(&ReplayOptions::slam, "scan"));
  EXPECT_FALSE(with(&ReplayOptions::poses, "given"));
  EXPECT_FALSE(with(&ReplayOptions::map, "points"));
  EXPECT_FALSE(with(&ReplayOptions::resolution_m, 0.1));
  EXPECT_FALSE(with(&ReplayOptions::log, options.log / "poses.csv"));
  EXPECT_TRUE(with(&ReplayOptions::log, recorded)) << "the file alone";
  std::filesystem::remove(recorded);
  EXPECT_FALSE(plays_recording(options)) << "as runs of older programs";
}

TEST_F(ReplayRunTest, PlacesTheRobotByAnotherSlamWhereOneIsNamed) {
  options.slam = "multiscan";
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_EQ(text("pose_graph.g2o"), live_text("pose_graph.g2o")) << "the run's own";
  options.slam = "ekf";
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_NE(text("pose_graph.g2o"), live_text("pose_graph.g2o"));
  EXPECT_EQ(text("session.mcap"), live_text("session.mcap"));
  const auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("slam"), "ekf");
  EXPECT_EQ(report.at("replay").at("poses"), "ekf");
}

TEST_F(ReplayRunTest, OfTheFileAloneNeedsNothingBesideIt) {
  options.log = scratch / "lone.mcap";
  std::filesystem::copy_file(recorded, options.log);
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  for (const char* file : {"map.pgm", "points.csv", "trajectory.tum", "robot.toml"}) {
    EXPECT_EQ(text(file), files::read_text_file(scratch / "run" / file)) << file;
  }
  EXPECT_EQ(nlohmann::json::parse(text("summary.json"))["robot"], "uno_2wd");
}

TEST_F(ReplayRunTest, PlaysThePartThatIsAskedFor) {
  options.part.until_s = 0.05;  // In the midst of the first stop.
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("stops"), 0);
  EXPECT_EQ(report.at("replay").at("until_s"), 0.05);
  options.part = {.from_s = 0.162};
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("stops"), 1);
  EXPECT_EQ(report.at("replay").at("from_s"), 0.162);
}

TEST_F(ReplayRunTest, WaitsForRealTimeWhereASpeedIsAskedFor) {
  options.part.speed = 4.0;  // Of 0.32 s of the robot.
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_GT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(70));
  EXPECT_EQ(text("map.pgm"), live_text("map.pgm"));
}

TEST_F(ReplayRunTest, KeepsTheMapUpToWhereTheRecordingIsDamaged) {
  damage();
  EXPECT_EQ(run_replay(options), console::ExitCode::kRuntimeError);
  const auto report = nlohmann::json::parse(text("summary.json"));
  EXPECT_EQ(report.at("outcome"), "log-damaged");
  EXPECT_EQ(report.at("stops"), 1);
}

TEST_F(ReplayRunTest, OfARecordingWhoseWriterWasKilledHasWhatItWrote) {
  const std::string bytes = live_text("session.mcap");
  files::write_text_file(recorded, bytes.substr(0, bytes.find("ending")));
  EXPECT_EQ(run_replay(options), console::ExitCode::kOk);
  EXPECT_EQ(text("map.pgm"), live_text("map.pgm"));
  EXPECT_EQ(nlohmann::json::parse(text("summary.json")).at("replay").at("whole_recording"), false);
}

TEST_F(ReplayRunTest, MakesTheMapsAgainThatWereSetAside) {
  tests::WrittenRecording recording(profile);
  for (const double range_m : {1.0, 1.2, 1.0, 1.1}) {
    recording.add_stop(range_m);
  }
  recording.add(recording::SessionEventKind::kBeginNewMap, 2);
  recording.add_stop(1.0);
  recording.save(recorded);
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  EXPECT_TRUE(exists(previous_map_of(options.out, 1) / "map.pgm"));
  EXPECT_FALSE(exists(previous_map_of(options.out, 2)));
  const auto previous = nlohmann::json::parse(text("previous_1/summary.json"));
  EXPECT_EQ(previous.at("outcome"), "set-aside");
  EXPECT_EQ(previous.at("stops"), 2);
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
  damage();
  const std::string damaged = live_text("session.mcap");
  options.out = options.log;
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("the run is left as it is\n  next: "));
  EXPECT_EQ(live_text("session.mcap"), damaged);
}

TEST_F(ReplayRunTest, DestroysNoRecordingThatLiesInItsWay) {
  for (const char* name : {kPreviousRecordingName, "session_1.mcap"}) {
    std::filesystem::copy_file(recorded, options.log / name);
    ReplayOptions own = options;
    own.log = options.log / name;
    own.out = options.log;
    EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(own); }),
                HasSubstr("would be moved away by the run"))
        << name;
    EXPECT_EQ(live_text(name), live_text("session.mcap")) << name;
    std::filesystem::remove(options.log / name);
  }
}

TEST_F(ReplayRunTest, OfARunThatOnlyLocalizedIsAnError) {
  tests::WrittenRecording recording(profile);
  recording.recorder().describe("session", {{"command", kLocalizeCommand}});
  recording.add_stop(1.0);
  recording.save(recorded);
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("is of a run that localized, and has no map\n  next: "));
}

TEST_F(ReplayRunTest, OfNoTimeIsAnError) {
  options.part = {.from_s = 30.0, .until_s = 20.0};
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("--from 30 is not before --until 20"));
  options.part = {.from_s = 1000.0};
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("nothing was recorded from 1000 s"));
  options.part = {.speed = std::nan("")};
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { run_replay(options); }),
              HasSubstr("--speed nan is outside"));
}

TEST_F(ReplayRunTest, OfAnEmptyRecordingIsAnError) {
  tests::WrittenRecording(profile).save(recorded);
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
