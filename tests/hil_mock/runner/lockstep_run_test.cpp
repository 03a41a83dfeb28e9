// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_run.hpp"

#include <array>
#include <future>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/runner/faulty_board.hpp"
#include "hil_mock/runner/pty_endpoint.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::runner {
namespace {

using tests::kMs;

/// How the run of a robot has ended.
struct Ending {
  LockstepEnd end;
  std::optional<StopReport> stop;
};

/// A device in a thread of its own, and the host's ends of both channels.
class LockstepRunTest : public testing::Test {
 protected:
  LockstepRunTest() {
    run.on_end = [this](std::size_t, LockstepEnd end, const std::optional<StopReport>& stop) {
      endings.push_back({end, stop});
    };
  }

  /// Answers the one ending.
  std::future<Ending> start() {
    auto ending = std::async(std::launch::async, [this] {
      run.run();
      return endings.at(0);
    });
    EXPECT_EQ(channel.read_line(), "hello");
    return ending;
  }

  tests::ScratchFolder folder;
  FakeBoard board;
  world::RobotWorld robot_world{world::box_room(), {}, 1};
  RobotSimulation simulation{board, robot_world};
  PtyEndpoint endpoint{folder / "robot", WhenUnread::kKeep};
  LockstepServer server{folder / "lockstep", "hello"};
  RobotTeam team{{&simulation}};
  std::vector<LockstepSeat> seats{{simulation, endpoint, server}};
  LockstepRun run{team, seats};
  std::vector<Ending> endings;
  TestHost bytes = TestHost::open_terminal(endpoint.address());
  TestHost channel = TestHost::connect_local(folder / "lockstep");
};

TEST_F(LockstepRunTest, GrantsAreReachedAndBytesComeBack) {
  auto end = start();
  bytes.write("abc");
  channel.write("grant 20000 3\n");
  EXPECT_EQ(channel.read_line(), "reached 20000 3");
  EXPECT_EQ(bytes.read(3), "abc");
  channel.write("grant 25000 3\n");
  EXPECT_EQ(channel.read_line(), "reached 25000 3");
  channel.write("quit\n");
  EXPECT_EQ(end.get().end, LockstepEnd::kQuit);
  EXPECT_EQ(simulation.now_ns(), 25 * kMs);
}

TEST_F(LockstepRunTest, TheRobotIsCarriedOffWhenTheHostWantsIt) {
  auto end = start();
  channel.write("grant 10000 0\ncarry-off 50000\ngrant 50000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 0");
  EXPECT_EQ(channel.read_line(), "reached 50000 0");
  EXPECT_TRUE(robot_world.body().is_lifted());
  channel.write("grant 70000 0\nquit\n");
  end.get();
  EXPECT_FALSE(robot_world.body().is_lifted());
  EXPECT_NE(robot_world.T_world_robot().position_m(),
            robot_world.plan().T_world_start().position_m());
}

TEST_F(LockstepRunTest, ABoxIsPutWhenTheHostWantsIt) {
  std::vector<bool> stand;
  run.on_box = [&stand](std::size_t, const PutBox&, bool stands) { stand.push_back(stands); };
  auto end = start();
  channel.write("box 1000 0 300\nbox 0 0 300\ngrant 10000 0\nquit\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 0") << "it has no answer of its own";
  end.get();
  EXPECT_EQ(stand, (std::vector{true, false}));
  ASSERT_EQ(robot_world.plan().boxes_m().size(), 1U);
  EXPECT_TRUE(geometry::contains(robot_world.plan().boxes_m()[0], Eigen::Vector2d(3.0, 1.5)));
}

TEST_F(LockstepRunTest, TheTruthIsToldInTheFrameOfTheStartOnceTheHostWantsIt) {
  auto end = start();
  channel.write("grant 10000 0\ntell-truth\ngrant 20000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 0");
  EXPECT_EQ(channel.read_line(), "reached 20000 0 0 0 0");
  robot_world.place({1.0, 1.75, std::numbers::pi});
  channel.write("grant 30000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 30000 0 -1000000 250000 180000000");
  channel.write("quit\n");
  end.get();
}

TEST_F(LockstepRunTest, AGrantWaitsForTheBytesThatItCounts) {
  auto end = start();
  channel.write("grant 10000 0\ngrant 20000 4\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 0");
  bytes.write("late");
  EXPECT_EQ(channel.read_line(), "reached 20000 4");
  channel.write("quit\n");
  end.get();
  EXPECT_EQ(board.received_at_ns, 10 * kMs) << "received at the start of their grant";
}

TEST_F(LockstepRunTest, BytesBeyondTheGrantAreForTheNext) {
  auto end = start();
  bytes.write("onetwo");
  channel.write("grant 10000 3\ngrant 20000 6\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 3");
  EXPECT_EQ(channel.read_line(), "reached 20000 6");
  EXPECT_EQ(bytes.read(6), "onetwo");
  channel.write("quit\n");
  end.get();
}

/// The host goes on counting what it writes, and is told of no byte that does not come.
TEST(LockstepRun, NothingPassesWhileTheCableIsCut) {
  const tests::ScratchFolder folder;
  FaultyBoard board(std::make_unique<FakeBoard>(), {});
  world::RobotWorld robot_world(world::box_room(), {}, 1);
  RobotSimulation simulation(board, robot_world);
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kKeep);
  LockstepServer server(folder / "lockstep", "hello");
  RobotTeam team({&simulation});
  std::vector<LockstepSeat> seats{{simulation, endpoint, server}};
  LockstepRun run(team, seats);
  run.on_cut_cable = [&board](std::size_t, std::int64_t for_ns) { board.cut_cable(for_ns); };
  auto end = std::async(std::launch::async, [&run] { run.run(); });
  TestHost bytes = TestHost::open_terminal(endpoint.address());
  TestHost channel = TestHost::connect_local(folder / "lockstep");
  EXPECT_EQ(channel.read_line(), "hello");
  bytes.write("abcdef");
  channel.write("grant 10000 2\ncut-cable 20000\ngrant 20000 3\ngrant 30000 4\ngrant 40000 6\n");
  EXPECT_EQ(channel.read_line(), "reached 10000 2");
  EXPECT_EQ(channel.read_line(), "reached 20000 2");
  EXPECT_EQ(channel.read_line(), "reached 30000 2");
  EXPECT_EQ(channel.read_line(), "reached 40000 4");
  EXPECT_EQ(bytes.read(4), "abef");
  channel.write("quit\n");
  end.get();
}

TEST_F(LockstepRunTest, WhenTheHostVanishesItReportsWhenTheWheelsStopped) {
  board.duty = {0.5, 0.5};
  board.stop_at_ns = 300 * kMs;
  auto end = start();
  channel.write("grant 100000 0\n");
  EXPECT_EQ(channel.read_line(), "reached 100000 0");
  channel.close();
  const Ending ending = end.get();
  EXPECT_EQ(ending.end, LockstepEnd::kHostGone);
  ASSERT_TRUE(ending.stop);
  EXPECT_EQ(ending.stop->last_grant_ns, 100 * kMs);
  EXPECT_EQ(ending.stop->stopped_after_ns, 200 * kMs);
  EXPECT_EQ(simulation.now_ns(), 2100 * kMs);
}

TEST_F(LockstepRunTest, WheelsThatGoOnAreReportedToo) {
  board.duty = {0.5, 0.5};
  auto end = start();
  channel.close();
  const Ending ending = end.get();
  ASSERT_TRUE(ending.stop);
  EXPECT_EQ(ending.stop->stopped_after_ns, std::nullopt);
}

TEST_F(LockstepRunTest, RefusesWhatIsNoRequest) {
  auto end = start();
  channel.write("please 1\n");
  EXPECT_THROW(end.get(), std::runtime_error);
}

/// Three robots and the hosts' ends of their channels.
class LockstepTeamTest : public testing::Test {
 protected:
  struct Robot {
    Robot(const tests::ScratchFolder& folder, std::size_t number)
        : robot_world(world::box_room({}, {1.0 + static_cast<double>(number), 1.5, 0.0}), {}, 1),
          simulation(board, robot_world),
          endpoint(folder / ("robot" + std::to_string(number)), WhenUnread::kKeep),
          server(folder / ("lockstep" + std::to_string(number)), "hello"),
          bytes(TestHost::open_terminal(endpoint.address())) {}

    FakeBoard board;
    world::RobotWorld robot_world;
    RobotSimulation simulation;
    PtyEndpoint endpoint;
    LockstepServer server;
    TestHost bytes;
    std::optional<TestHost> channel;
  };

  LockstepTeamTest() {
    std::vector<RobotSimulation*> simulations;
    for (std::size_t i = 0; i < 3; ++i) {
      robots.push_back(std::make_unique<Robot>(folder, i));
      simulations.push_back(&robots[i]->simulation);
      seats.emplace_back(robots[i]->simulation, robots[i]->endpoint, robots[i]->server);
    }
    team.emplace(simulations);
    run.emplace(*team, seats);
    run->on_end = [this](
                      std::size_t robot, LockstepEnd end, const std::optional<StopReport>& stop) {
      endings[robot] = Ending{end, stop};
      if (end == LockstepEnd::kQuit) {
        robots[robot]->server.send_bye();
      }
    };
    device = std::async(std::launch::async, [this] { run->run(); });
  }

  void connect(std::size_t robot) {
    robots[robot]->channel.emplace(
        TestHost::connect_local(folder / ("lockstep" + std::to_string(robot))));
    EXPECT_EQ(host(robot).read_line(), "hello");
  }

  TestHost& host(std::size_t robot) { return *robots[robot]->channel; }

  tests::ScratchFolder folder;
  std::vector<std::unique_ptr<Robot>> robots;
  std::vector<LockstepSeat> seats;
  std::optional<RobotTeam> team;
  std::optional<LockstepRun> run;
  std::array<std::optional<Ending>, 3> endings;
  std::future<void> device;
};

TEST_F(LockstepTeamTest, TimeGoesAsFarAsAllHaveGrantedAndWhoIsNotThereHoldsIt) {
  connect(0);
  connect(1);
  host(0).write("grant 10000 0\n");
  host(1).write("grant 4000 0\n");
  robots[0]->bytes.write("x");
  connect(2);
  host(2).write("grant 20000 0\n");
  EXPECT_EQ(host(1).read_line(), "reached 4000 0") << "all that is granted by all";
  host(1).write("grant 30000 0\n");
  EXPECT_EQ(host(0).read_line(), "reached 10000 0");
  host(0).write("grant 20000 1\n");
  EXPECT_EQ(host(0).read_line(), "reached 20000 1");
  EXPECT_EQ(host(2).read_line(), "reached 20000 0");
  EXPECT_EQ(robots[0]->board.received_at_ns, 10 * kMs) << "at the start of their grant";
  for (std::size_t i = 0; i < 3; ++i) {
    host(i).write("quit\n");
  }
  EXPECT_EQ(host(0).read_line(), "bye");
  EXPECT_EQ(host(2).read_line(), "bye");
  EXPECT_EQ(host(1).read_line(), "reached 30000 0") << "nobody holds it any longer";
  EXPECT_EQ(host(1).read_line(), "bye");
  device.get();
}

TEST_F(LockstepTeamTest, WhoHasQuitHoldsTheOthersNoLongerAndIsToldSoAtOnce) {
  for (std::size_t i = 0; i < 3; ++i) {
    connect(i);
  }
  host(0).write("quit\n");
  EXPECT_EQ(host(0).read_line(), "bye");
  host(1).write("grant 50000 0\n");
  host(2).write("grant 50000 0\n");
  EXPECT_EQ(host(1).read_line(), "reached 50000 0");
  EXPECT_EQ(host(2).read_line(), "reached 50000 0");
  host(1).write("quit\n");
  host(2).write("quit\n");
  device.get();
  EXPECT_EQ(robots[0]->simulation.now_ns(), 50 * kMs) << "its board runs on";
}

TEST_F(LockstepTeamTest, OfWhoHasVanishedTheWheelsAreWatchedWhileTheOthersGoOn) {
  for (std::size_t i = 0; i < 3; ++i) {
    connect(i);
    robots[i]->board.duty = {0.1, 0.1};
  }
  robots[0]->board.stop_at_ns = 230 * kMs;
  const auto grant_all = [&](const std::string& until_us, std::size_t first) {
    for (std::size_t i = first; i < 3; ++i) {
      host(i).write("grant " + until_us + " 0\n");
    }
    for (std::size_t i = first; i < 3; ++i) {
      EXPECT_EQ(host(i).read_line(), "reached " + until_us + " 0");
    }
  };
  grant_all("200000", 0);
  host(0).close();
  grant_all("2500000", 1);
  host(1).write("quit\n");
  host(2).write("quit\n");
  device.get();
  EXPECT_EQ(robots[0]->simulation.now_ns(), 2500 * kMs);
  ASSERT_TRUE(endings[0] && endings[0]->stop);
  EXPECT_EQ(endings[0]->end, LockstepEnd::kHostGone);
  EXPECT_EQ(endings[0]->stop->last_grant_ns, 200 * kMs);
  EXPECT_EQ(endings[0]->stop->stopped_after_ns, 30 * kMs);
  EXPECT_EQ(endings[1]->end, LockstepEnd::kQuit);
}

TEST_F(LockstepTeamTest, ABoxOfOneStandsForAll) {
  for (std::size_t i = 0; i < 3; ++i) {
    connect(i);
  }
  host(1).write("box 0 800 300\nbox 1000 0 300\nquit\n");
  EXPECT_EQ(host(1).read_line(), "bye");
  host(0).write("quit\n");
  host(2).write("quit\n");
  device.get();
  for (const auto& robot : robots) {
    ASSERT_EQ(robot->robot_world.plan().boxes_m().size(), 1U) << "the second was on a robot";
    EXPECT_TRUE(
        geometry::contains(robot->robot_world.plan().boxes_m()[0], Eigen::Vector2d(2.0, 2.3)));
  }
}

}  // namespace
}  // namespace echomap::runner
