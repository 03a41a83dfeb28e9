// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/console/interrupt.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/points_csv.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class ReplayCommandTest : public ::testing::Test {
 protected:
  ReplayCommandTest() {
    options_.log = fs::path(ECHOMAP_SOURCE_DIR) / "tests/data/small_room.clf";
    options_.out = scratch_ / "run";
    options_.force = true;  // Some tests replay twice.
    options_.headless = true;
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(options_.out / "summary.json"));
  }
  void write_log(const std::string& name, const std::string& text) {
    options_.log = scratch_ / name;
    files::write_text_file(options_.log, text);
  }
  std::string error() {
    return tests::thrown_text<std::runtime_error>([&] { run_replay(options_); });
  }

  tests::ScratchFolder scratch_;
  ReplayOptions options_;
};

TEST_F(ReplayCommandTest, MakesCellsOfMillimetres) {
  options_.poses = "given";
  options_.resolution_m = 0.005;
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_EQ(exports::read_pgm_yaml(options_.out / "map.yaml").resolution_m(), 0.005);
}

TEST_F(ReplayCommandTest, PointsHaveNoCells) {
  options_.map = "points";
  options_.resolution_m = 0.005;
  EXPECT_THAT(error(), HasSubstr("a map of points has none\n  next: leave it out, or --map grid"));
}

TEST_F(ReplayCommandTest, SaysWhatARecordingWithoutEchoesHolds) {
  options_.log = scratch_ / "field" / recording::kSessionFileName;
  fs::create_directories(scratch_ / "field");
  tests::WrittenRecording recording(session::load_robot_profile("epuck"));
  recording.begin(options_.log);
  recording.save(options_.log);
  options_.log = scratch_ / "field";
  options_.map = "points";
  EXPECT_THAT(
      error(),
      AllOf(HasSubstr("a recording of robot 'epuck', which has no sonar: it holds odometry, "
                      "contacts and infra-red readings, and no echoes"),
            HasSubstr("next: echomap replay " + options_.log.string() + " --out field_again")));
  options_.map = "grid";
  options_.slam = "ekf";
  EXPECT_THAT(error(), HasSubstr("--slam ekf needs a sonar"));
}

TEST_F(ReplayCommandTest, ByGivenPosesTheRoomIsAsItIs) {
  options_.poses = "given";
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  const auto map = exports::read_pgm_yaml(options_.out / "map.yaml");
  const auto state_at = [&map](double x_m, double y_m) {
    return map.state(map.cell_at({x_m, y_m}));
  };
  // The room is 4 x 3 m; a pillar of 0.4 m stands in its middle.
  EXPECT_EQ(state_at(0.5, 1.5), mapping::CellState::kFree);
  EXPECT_EQ(state_at(3.5, 1.5), mapping::CellState::kFree);
  EXPECT_EQ(state_at(2.0, 1.5), mapping::CellState::kUnknown);
  EXPECT_EQ(state_at(-0.1, 1.5), mapping::CellState::kUnknown);
  EXPECT_TRUE(state_at(2.02, 1.27) == mapping::CellState::kOccupied ||
              state_at(2.02, 1.32) == mapping::CellState::kOccupied)
      << "the front of the pillar is at y = 1.3";
  EXPECT_EQ(summary().at("replay").at("scans"), 48);
  EXPECT_EQ(summary().at("sim_seconds"), 23.5);
  EXPECT_EQ(exports::read_trajectory_tum(options_.out / "trajectory.tum").size(), 48U);
}

TEST_F(ReplayCommandTest, SlamPlacesTheScansBetterThanOdometry) {
  const auto error_m = [&](const std::string& slam) {
    options_.slam = slam;
    EXPECT_EQ(run_replay(options_), ExitCode::kOk);
    const auto found = exports::read_trajectory_tum(options_.out / "trajectory.tum");
    options_.slam.clear();
    options_.poses = "given";
    EXPECT_EQ(run_replay(options_), ExitCode::kOk);
    options_.poses = "odometry";
    const auto given = exports::read_trajectory_tum(options_.out / "trajectory.tum");
    EXPECT_EQ(found.size(), given.size());
    const auto moved = [](const auto& trajectory) {
      return trajectory.front().T_map_robot.inverse() * trajectory.back().T_map_robot;
    };
    return (moved(found).position_m() - moved(given).position_m()).norm();
  };
  const double odometry_m = error_m("");
  EXPECT_GT(odometry_m, 0.1);
  EXPECT_LT(error_m("scan"), 0.5 * odometry_m);
}

TEST_F(ReplayCommandTest, SlamWritesItsGraphAndHowSureItIs) {
  for (const char* slam : {"scan", "multiscan", "ekf"}) {
    options_.slam = slam;
    EXPECT_EQ(run_replay(options_), ExitCode::kOk);
    const std::string graph = files::read_text_file(options_.out / "pose_graph.g2o");
    const auto trajectory = exports::read_trajectory_tum(options_.out / "trajectory.tum");
    std::istringstream first(graph);
    std::string tag;
    int id = -1;
    double x_m = 0.0;
    double y_m = 0.0;
    first >> tag >> id >> x_m >> y_m;
    EXPECT_EQ(tag, "VERTEX_SE2") << slam;
    EXPECT_NEAR(x_m, trajectory.front().T_map_robot.x_m(), 1e-5) << "in the trajectory's frame";
    EXPECT_NEAR(y_m, trajectory.front().T_map_robot.y_m(), 1e-5);
    EXPECT_THAT(graph, HasSubstr("\nEDGE_SE2 0 1 "));
    EXPECT_GT(summary()["pose_stddev_m"], 0.001) << slam;
    EXPECT_LT(summary()["pose_stddev_m"], 0.5) << slam;
    EXPECT_GT(summary()["pose_stddev_deg"], 0.01) << slam;
    EXPECT_LT(summary()["pose_stddev_deg"], 10.0) << slam;
  }
}

TEST_F(ReplayCommandTest, WithoutSlamThereIsNoGraph) {
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_FALSE(fs::exists(options_.out / "pose_graph.g2o"));
  EXPECT_TRUE(summary()["pose_stddev_m"].is_null());
}

TEST_F(ReplayCommandTest, SlamNeedsOdometryToBeginWith) {
  files::write_text_file(scratch_ / "poses.txt", "1 0 0 0\n2 0 0 0\n");
  write_log("measurement.txt", "1 1 1 1 1 1 1 1 1\n2 1 1 1 1 1 1 1 1\n");
  options_.slam = "multiscan";
  EXPECT_THAT(error(), HasSubstr("has no odometry, but SLAM needs both\n  next: leave out --slam"));
  write_log("poses.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  EXPECT_THAT(error(), HasSubstr("has no scans, but SLAM needs both"));
}

TEST_F(ReplayCommandTest, SlamForLasersRefusesSonars) {
  write_log("Garden.txt", "0,0,0,376,97,60,60,0,0\n4,4,0,376,97,60,60,0,0\n");
  options_.format = "bigwheelbot";
  options_.slam = "scan";
  EXPECT_THAT(error(), HasSubstr("is for lasers"));
  for (const char* for_sonars : {"multiscan", "ekf"}) {
    options_.slam = for_sonars;
    EXPECT_EQ(run_replay(options_), ExitCode::kOk) << for_sonars;
  }
}

TEST_F(ReplayCommandTest, CtrlCInSlamLeavesTheMapOfWhatItHadFound) {
  options_.slam = "scan";
  const auto replay_and_interrupt = [&] {
    console::catch_interrupts();
    std::raise(SIGINT);
    std::exit(static_cast<int>(run_replay(options_)));
  };
  EXPECT_EXIT(replay_and_interrupt(), ::testing::ExitedWithCode(130), "");
  EXPECT_EQ(summary().at("outcome"), "interrupted");
}

TEST_F(ReplayCommandTest, ADamagedLogKeepsItsMapBySlamUpToThere) {
  write_log("cut.clf", files::read_text_file(options_.log) + "FLASER 60 1.0\n");
  options_.slam = "scan";
  EXPECT_EQ(run_replay(options_), ExitCode::kRuntimeError);
  EXPECT_EQ(summary().at("outcome"), "log-damaged");
  EXPECT_EQ(exports::read_trajectory_tum(options_.out / "trajectory.tum").size(), 48U);
}

TEST_F(ReplayCommandTest, WritesTheLandmarksOfALogWhereItsPosesPutThem) {
  files::write_text_file(scratch_ / "Barcodes.dat", "7 45\n");
  files::write_text_file(scratch_ / "Robot1_Measurement.dat", "12 45 2.0 0.0\n");
  write_log("Robot1_Odometry.dat", "10 0.5 0\n12 0 0\n");
  options_.format = "mrclam";
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_EQ(files::read_text_file(options_.out / "landmarks.csv"),
            "stamp_s,id,range_m,bearing_rad,x_m,y_m\n12,7,2,0,3,0\n");
  EXPECT_EQ(summary()["replay"]["sightings"], 1);
}

TEST_F(ReplayCommandTest, PointsAreAllEchoesAndNoFloor) {
  options_.map = "points";
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_EQ(tests::read_points_csv(options_.out / "points.csv").size(), 48U * 60U);
  EXPECT_FALSE(exports::read_outline_geojson(options_.out / "outline.geojson"));
  const auto map = exports::read_pgm_yaml(options_.out / "map.yaml");
  EXPECT_EQ(map.state(map.cell_at({1.0, 0.0})), mapping::CellState::kUnknown);
}

TEST_F(ReplayCommandTest, AGridComesWithTheOutlineOfItsFloor) {
  options_.poses = "given";
  for (const char* map : {"grid", "polygon"}) {
    options_.map = map;
    EXPECT_EQ(run_replay(options_), ExitCode::kOk);
    const auto outline = exports::read_outline_geojson(options_.out / "outline.geojson");
    ASSERT_TRUE(outline) << map;
    EXPECT_NEAR(outline->area_m2(), 4.0 * 3.0 - 0.4 * 0.4, 1.0) << map;
    EXPECT_EQ(outline->holes_m().size(), 1U) << "the pillar";
  }
}

TEST_F(ReplayCommandTest, ARunsOwnPointsBecomeAMapAgain) {
  options_.map = "points";
  ASSERT_EQ(run_replay(options_), ExitCode::kOk);
  options_.log = options_.out;
  options_.out = scratch_ / "again";
  options_.poses = "given";
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_EQ(summary().at("points"), 48 * 60);
}

TEST_F(ReplayCommandTest, ADamagedLogKeepsItsMapUpToThere) {
  const std::string whole = files::read_text_file(options_.log);
  const std::size_t middle = whole.find('\n', whole.size() / 2) + 100;
  for (const std::string& rest : {std::string("\n"), whole.substr(whole.find('\n', middle))}) {
    write_log("damaged.clf", whole.substr(0, middle) + rest);
    EXPECT_EQ(run_replay(options_), ExitCode::kRuntimeError);
    EXPECT_EQ(summary().at("outcome"), "log-damaged");
    EXPECT_GT(summary().at("free_area_m2"), 1.0);
  }
}

TEST_F(ReplayCommandTest, ALogThatIsCutOffInItsLastLineIsReadUpToThere) {
  const std::string whole = files::read_text_file(options_.log);
  const std::size_t middle = whole.find('\n', whole.size() / 2) + 1;
  write_log("whole.clf", whole.substr(0, middle));
  EXPECT_EQ(run_replay(options_), ExitCode::kOk);
  const auto expected = files::read_text_file(options_.out / "points.csv");
  write_log("cut.clf", whole.substr(0, middle + 100));
  for (const char* slam : {"", "multiscan"}) {
    options_.slam = slam;
    EXPECT_EQ(run_replay(options_), ExitCode::kOk);
    EXPECT_EQ(summary().at("outcome"), "finished");
    if (options_.slam.empty()) {
      EXPECT_EQ(files::read_text_file(options_.out / "points.csv"), expected);
    }
  }
}

TEST_F(ReplayCommandTest, ALogWithoutThePosesThatShouldCountSaysWhatToDo) {
  write_log("poses.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  options_.poses = "given";
  EXPECT_EQ(run_replay(options_), ExitCode::kOk) << "a trajectory needs no scans";

  files::write_text_file(scratch_ / "poses.txt", "1 0 0 0\n2 0 0 0\n");
  write_log("measurement.txt", "1 1 1 1 1 1 1 1 1\n2 1 1 1 1 1 1 1 1\n");
  options_.poses = "odometry";
  EXPECT_THAT(error(), HasSubstr("has no odometry\n  next: --poses given"));

  write_log(
      "robotdata1.log", "O 0 0 0 0\nL 0 0 0 0 0 0 " + [] {
        std::string ranges;
        for (int i = 0; i < 180; ++i) {
          ranges += "100 ";
        }
        return ranges;
      }() + "1\n");
  options_.poses = "given";
  EXPECT_THAT(error(), HasSubstr("gives no poses for its scans\n  next: --poses odometry"));
}

TEST_F(ReplayCommandTest, AMapThatOnlyADamagedPoseMakesHugeIsRefused) {
  write_log("far.clf", "FLASER 1 1 0 0 0 0 0 0 1 h 1\nFLASER 1 1 0 0 0 1000 1000 0 2 h 2\n");
  EXPECT_THAT(error(), HasSubstr("a damaged pose?\n  next: --resolution 0.1"));
}

TEST_F(ReplayCommandTest, ARefusedReplayLeavesTheEarlierRunAsItIs) {
  ASSERT_EQ(run_replay(options_), ExitCode::kOk);
  const std::string map = files::read_text_file(options_.out / "map.pgm");
  write_log("far.clf", "FLASER 1 1 0 0 0 0 0 0 1 h 1\nFLASER 1 1 0 0 0 1000 1000 0 2 h 2\n");
  EXPECT_THAT(error(), HasSubstr("--resolution 0.1"));
  EXPECT_EQ(files::read_text_file(options_.out / "map.pgm"), map);
}

TEST_F(ReplayCommandTest, OnlyARecordingIsPlayedInParts) {
  options_.part.until_s = 5.0;
  EXPECT_THAT(error(), HasSubstr("--until, --speed and --step are for recordings of echomap"));
  options_.part = {};
  options_.step = true;
  EXPECT_THAT(error(), HasSubstr("are for recordings of echomap"));
}

TEST_F(ReplayCommandTest, TheMapOfARunsEchoesDoesNotTakeTheRunsPlace) {
  options_.map = "points";
  ASSERT_EQ(run_replay(options_), ExitCode::kOk);
  tests::WrittenRecording(session::load_robot_profile("uno_2wd"))
      .save(options_.out / recording::kSessionFileName);
  const std::string points = files::read_text_file(options_.out / "points.csv");
  options_.log = options_.out;
  EXPECT_THAT(error(),
              AllOf(HasSubstr("overwrite the run"), HasSubstr("another folder with --out")));
  EXPECT_EQ(files::read_text_file(options_.out / "points.csv"), points);
}

TEST_F(ReplayCommandTest, CtrlCLeavesAMapThatCanBeRead) {
  const auto replay_and_interrupt = [&] {
    console::catch_interrupts();
    std::raise(SIGINT);
    std::exit(static_cast<int>(run_replay(options_)));
  };
  EXPECT_EXIT(replay_and_interrupt(), ::testing::ExitedWithCode(130), "");
  EXPECT_EQ(summary().at("outcome"), "interrupted");
  EXPECT_GT(exports::read_pgm_yaml(options_.out / "map.yaml").columns(), 0);
}

TEST_F(ReplayCommandTest, AnEmptyLogMakesNoMap) {
  write_log("empty.clf", "");
  options_.format = "carmen";
  EXPECT_THAT(error(), HasSubstr("empty.clf is empty: it has no record\n  next: "));
  EXPECT_FALSE(exists(options_.out / "map.pgm"));
}

TEST_F(ReplayCommandTest, SaysHowItHasEnded) {
  options_.poses = "given";
  ASSERT_EQ(run_replay(options_), ExitCode::kOk);
  EXPECT_EQ(summary().at("finished"), true);
  EXPECT_EQ(summary().at("why"), "the log was played to its end");
  EXPECT_THAT(summary().at("next").get<std::string>(), HasSubstr("echomap localize --map "));
}

TEST_F(ReplayCommandTest, WhatTheLogIsMustBeSaidOrPlain) {
  write_log("a.txt", "1 2 3\n");
  EXPECT_THAT(error(), HasSubstr("what format is it? Name it with --format"));
}

TEST(RealReplay, EdmontonIsReplayedToAMap) {
  ReplayOptions options;
  options.log = tests::real_data("edmonton/dataset_edmonton.rawlog_LASER.txt.gz");
  ECHOMAP_SKIP_WITHOUT(options.log);
  const tests::ScratchFolder scratch;
  options.out = scratch / "run";
  options.headless = true;
  EXPECT_EQ(run_replay(options), ExitCode::kOk);
  const auto summary = nlohmann::json::parse(files::read_text_file(options.out / "summary.json"));
  EXPECT_NEAR(summary.at("travelled_m").get<double>(), 326.7, 0.1);
  EXPECT_GT(summary.at("free_area_m2"), 500.0);
}

}  // namespace
}  // namespace echomap::apps
