// SPDX-License-Identifier: MIT
/// `echomap replay` of a run writes what the run wrote, byte for byte.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;

class LiveIsReplay : public ::testing::Test {
 protected:
  /// The demo on the native mock, without the kidnapping at its end.
  void drive(const std::vector<std::string>& more) {
    fs::remove_all(run);
    std::vector<std::string> arguments{
        "demo", "--emulator=mock", "--no-kidnap", "--headless", "--out=" + run.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program("echomap", arguments, scratch / "log").wait();
  }
  /// At the port of a mock that somebody carries off while it maps.
  void drive_carried_off(const std::string& kidnap) {
    const fs::path socket = scratch / "lockstep";
    const fs::path port = scratch / "robot";
    Program robot(
        "echomap-mock",
        {"--kidnap=" + kidnap, "--link=" + port.string(), "--lockstep=" + socket.string()},
        scratch / "robot_log");
    EXPECT_TRUE(eventually([&] { return exists(socket) && exists(port); }));
    const std::vector<std::string> arguments{"explore",
                                             "--port=" + port.string(),
                                             "--lockstep=" + socket.string(),
                                             "--strategy=nxt-farthest",
                                             "--out=" + run.string()};
    EXPECT_THAT(Program("echomap", arguments, scratch / "log").wait().status,
                ::testing::AnyOf(0, kUnfinished));
    EXPECT_EQ(robot.wait().status, 0);
  }
  Ended replay(const std::vector<std::string>& more = {}) {
    fs::remove_all(again);
    std::vector<std::string> arguments{
        "replay", run.string(), "--headless", "--out=" + again.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Program("echomap", arguments, scratch / "replay_log").wait();
  }
  static nlohmann::json summary(const fs::path& folder) {
    return nlohmann::json::parse(files::read_text_file(folder / "summary.json"));
  }
  void expect_same_summary(const fs::path& folder) const {
    auto replayed = summary(again / folder);
    replayed.erase("replay");
    auto live = summary(run / folder);
    EXPECT_EQ(replayed.at("points"), live.at("points"));
    for (auto item = replayed.begin(); item != replayed.end(); ++item) {
      EXPECT_EQ(item.value(), live.at(item.key())) << item.key();
    }
  }
  /// Only a drive makes these: the simulator's truth, the log of the simulated robot, and the grid
  /// that a strategy kept for itself.
  static bool is_of_the_drive(const fs::path& file) {
    return *file.begin() == "truth" || file.filename() == "robot.log" ||
           file.filename() == "confidence_grid.csv";
  }
  static std::set<fs::path> files_in(const fs::path& folder) {
    std::set<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path file = fs::relative(entry.path(), folder);
      if (entry.is_regular_file() && !is_of_the_drive(file)) {
        files.insert(file);
      }
    }
    return files;
  }
  /// The replay has the files of the run, and all but the summary are the same.
  void expect_replayed() {
    const Ended ended = replay();
    ASSERT_EQ(ended.status, 0) << ended.said;
    for (const char* name : {"map.pgm", "map.yaml", "points.csv", "poses.csv", "trajectory.tum"}) {
      EXPECT_TRUE(exists(again / name)) << name;
    }
    EXPECT_EQ(files_in(run), files_in(again));
    for (const fs::path& file : files_in(again)) {
      if (file.filename() == "summary.json") {
        expect_same_summary(file.parent_path());
      } else {
        EXPECT_TRUE(files::read_text_file(run / file) == files::read_text_file(again / file))
            << file;
      }
    }
  }

  tests::ScratchFolder scratch;
  fs::path run = scratch / "run";
  fs::path again = scratch / "again";
};

TEST_F(LiveIsReplay, InTheDemoRoom) {
  for (int seed = 1; seed <= (tests::runs_every_seed() ? 2 : 1); ++seed) {
    drive({"--seed=" + std::to_string(seed), "--stops=8"});
    expect_replayed();
  }
}

TEST_F(LiveIsReplay, OfEveryFilterRobotAndStrategy) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--slam=ekf", "--stops=5"},
        {"--slam=none", "--stops=5", "--world=office"},
        {"--strategy=nxt-farthest", "--stops=4", "--world=l_room"},
        {"--robot=uno_geiger", "--world=source_rooms", "--stops=3"},
        {"--robot=epuck", "--world=epuck_field", "--strategy=random-bounce", "--seconds=30"},
        {"--robot=create", "--world=create_l", "--strategy=coastal"}}) {
    drive(options);
    expect_replayed();
  }
}

TEST_F(LiveIsReplay, AcrossAResetOfTheBoard) {
  drive({"--part-faults=board-reset@62:3", "--stops=8"});
  EXPECT_EQ(summary(run).at("link").at("resets"), 1);
  expect_replayed();
}

TEST_F(LiveIsReplay, UnderAnOverheadCamera) {
  drive({"--fixes=udp:127.0.0.1:" + free_port(), "--stops=5"});
  expect_replayed();
}

TEST_F(LiveIsReplay, WithTheMapsOfARobotThatWasCarriedOff) {
  drive_carried_off("40,2,2.2,2.4,-90");
  EXPECT_EQ(summary(run).at("previous_maps"), 1);
  expect_replayed();
  EXPECT_TRUE(exists(again / "previous_1" / "map.pgm"));
}

TEST_F(LiveIsReplay, WithMapsThatWereJoined) {
  drive_carried_off("80,2,2.2,2.4,-90");
  EXPECT_EQ(summary(run).at("maps_joined"), 1);
  expect_replayed();
}

TEST_F(LiveIsReplay, OptionsForAnotherMapAreFollowedAndTold) {
  drive({"--stops=4"});
  for (const char* option :
       {"--slam=ekf", "--slam=scan", "--resolution=0.1", "--map=points", "--poses=given"}) {
    const Ended ended = replay({option});
    EXPECT_EQ(ended.status, 0) << option << ended.said;
    EXPECT_THAT(ended.said, ::testing::HasSubstr("the map will differ from the run's: ")) << option;
  }
}

}  // namespace
}  // namespace echomap::test
