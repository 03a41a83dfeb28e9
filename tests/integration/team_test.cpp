// SPDX-License-Identifier: MIT
/// Two emulated robots in one world, each explored by a host of its own.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/session/simulated_robots.hpp"
#include "host/transport/lockstep_channel.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;

constexpr double kHullsM = 2.0 * 0.09;

class TeamInOneWorld : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(std::string(ECHOMAP_BINARY_DIR "/bin/") + GetParam())) {
      GTEST_SKIP() << GetParam() << " was not built on this machine";
    }
  }

  fs::path run(std::size_t robot) const { return scratch / ("run" + std::to_string(robot)); }
  fs::path truth(std::size_t robot) const {
    return scratch / "truth" / ("robot" + std::to_string(robot));
  }

  std::unique_ptr<Program> start_host(std::size_t robot) const {
    const std::string end = "." + std::to_string(robot);
    return std::make_unique<Program>("echomap",
                                     std::vector<std::string>{
                                         "explore",
                                         "--headless",
                                         "--strategy=nxt-farthest",
                                         "--stops=3",
                                         "--seed=" + std::to_string(20 + robot),
                                         "--port=" + (scratch / "port").string() + end,
                                         "--lockstep=" + (scratch / "clock").string() + end,
                                         "--out=" + run(robot).string(),
                                     },
                                     scratch / ("host" + std::to_string(robot) + ".log"));
  }

  /// Both from their starts to three stops each; the host of `first` connects first.
  void explore(std::size_t first, const std::vector<std::string>& more) {
    for (const fs::path& old : {run(0), run(1), scratch / "truth"}) {
      fs::remove_all(old);
    }
    std::vector<std::string> arguments{"--robots=2",
                                       "--world=office",
                                       "--seed=4",
                                       "--link=" + (scratch / "port").string(),
                                       "--lockstep=" + (scratch / "clock").string(),
                                       "--truth=" + (scratch / "truth").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program device(GetParam(), arguments, scratch / "device.log");
    ASSERT_TRUE(eventually([&] { return fs::exists((scratch / "clock.1")); }));
    std::vector<std::unique_ptr<Program>> hosts;
    hosts.push_back(start_host(first));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    hosts.push_back(start_host(1 - first));
    for (const auto& host : hosts) {
      const Ended ended = host->wait();
      EXPECT_TRUE(ended.status == 0 || ended.status == kUnfinished) << ended.said;
    }
    EXPECT_EQ(device.wait().status, 0);
  }

  /// All that must not depend on the machine, of both robots.
  std::vector<std::string> artefacts() const {
    std::vector<std::string> all;
    for (const std::size_t robot : {0U, 1U}) {
      for (const char* name : {"session.mcap", "map.pgm", "trajectory.tum", "points.csv"}) {
        all.push_back(files::read_text_file(run(robot) / name));
      }
      for (const char* name : {"truth.json", "truth.tum", "truth_map.pgm"}) {
        all.push_back(files::read_text_file(truth(robot) / name));
      }
    }
    return all;
  }

  std::vector<Eigen::Vector2d> places_m(std::size_t robot) const {
    std::ifstream file(truth(robot) / "truth.tum");
    std::vector<Eigen::Vector2d> places;
    std::string line;
    while (std::getline(file, line)) {
      std::istringstream numbers(line);
      double at_s = 0.0;
      Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
      numbers >> at_s >> place_m.x() >> place_m.y();
      places.push_back(place_m);
    }
    return places;
  }

  tests::ScratchFolder scratch;
};

TEST_P(TeamInOneWorld, RepeatsToTheByteWhoeverConnectsFirst) {
  explore(0, {});
  const auto before = artefacts();
  explore(1, {});
  EXPECT_TRUE(before == artefacts());
}

TEST_P(TeamInOneWorld, EachRunIsScoredAgainstItsOwnTruth) {
  explore(0, {"--starts=drawn"});
  for (const std::size_t robot : {0U, 1U}) {
    const fs::path report = scratch / "scores.json";
    const Ended ended = Program("echomap",
                                {"eval",
                                 run(robot).string(),
                                 "--truth=" + truth(robot).string(),
                                 "--json=" + report.string()},
                                scratch / "eval.log")
                            .wait();
    ASSERT_EQ(ended.status, 0) << ended.said;
    const auto scores = nlohmann::json::parse(files::read_text_file(report));
    EXPECT_LT(scores["ate_rmse_m"].get<double>(), 0.1) << robot;
  }
}

/// They begin half a metre apart, each looking at the other.
TEST_P(TeamInOneWorld, NeitherDrivesIntoTheOther) {
  explore(0, {"--starts=1.4,1.6,0;1.9,1.6,180"});
  const auto first_m = places_m(0);
  const auto second_m = places_m(1);
  // Whoever has quit is written down up to there; the last line of each may lie between two
  // samples.
  const std::size_t together = std::min(first_m.size(), second_m.size()) - 1;
  ASSERT_GT(together, 1000U);
  double nearest_m = 1e9;
  for (std::size_t i = 0; i < together; ++i) {
    nearest_m = std::min(nearest_m, (first_m[i] - second_m[i]).norm());
  }
  EXPECT_GE(nearest_m, kHullsM - 1e-5);
  EXPECT_LE(nearest_m, 0.51);
}

INSTANTIATE_TEST_SUITE_P(Boards,
                         TeamInOneWorld,
                         testing::Values("echomap-mock", "echomap-simavr"),
                         [](const auto& board) {
                           return std::string(board.param).substr(std::string("echomap-").size());
                         });

session::SimulatedRobotOptions mock_team(std::size_t robots) {
  session::SimulatedRobotOptions options;
  options.emulator = "mock";
  options.world = "office";
  options.robots = robots;
  return options;
}

TEST(SimulatedRobots, HasAWayToEachRobotAndItsTruth) {
  const tests::ScratchFolder out;
  const auto body = files::bundled_file("uno_2wd", "hil_mock/robots", "robot");
  const session::SimulatedRobots robots(mock_team(2), session::Seed(3), body, out.path());
  ASSERT_EQ(robots.size(), 2U);
  std::vector<std::thread> hosts;
  std::vector<char> reached(2, 0);
  for (std::size_t i = 0; i < 2; ++i) {
    hosts.emplace_back([&, i] {
      transport::LockstepChannel channel(robots.connection(i).lockstep);
      const auto at = channel.grant(50'000, 0);
      reached[i] = at && channel.quit() ? 1 : 0;
    });
  }
  for (std::thread& host : hosts) {
    host.join();
  }
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_TRUE(reached[i]);
    EXPECT_TRUE(fs::exists(robots.truth(i) / "truth.json"));
  }
  EXPECT_NE(robots.truth(0), robots.truth(1));
  EXPECT_NE(robots.connection(0).ports, robots.connection(1).ports);
}

TEST(SimulatedRobots, ARoomWithoutPlaceIsTheUsersFault) {
  const tests::ScratchFolder out;
  const auto body = files::bundled_file("uno_2wd", "hil_mock/robots", "robot");
  try {
    const session::SimulatedRobots robots(mock_team(16), session::Seed(3), body, out.path());
    ADD_FAILURE() << "16 robots do not fit";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
  }
}

}  // namespace
}  // namespace echomap::test
