// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_run.hpp"

#include <future>
#include <numbers>
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

/// A device in a thread of its own, and the host's ends of both channels.
class LockstepRunTest : public testing::Test {
 protected:
  std::future<LockstepEnd> start() {
    auto end = std::async(std::launch::async, [this] { return run.run(); });
    EXPECT_EQ(channel.read_line(), "hello");
    return end;
  }

  tests::ScratchFolder folder;
  FakeBoard board;
  world::RobotWorld robot_world{world::box_room(), {}, 1};
  RobotSimulation simulation{board, robot_world};
  PtyEndpoint endpoint{folder / "robot", WhenUnread::kKeep};
  LockstepServer server{folder / "lockstep", "hello"};
  LockstepRun run{simulation, endpoint, server};
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
  EXPECT_EQ(end.get(), LockstepEnd::kQuit);
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
  run.on_box = [&stand](const PutBox&, bool stands) { stand.push_back(stands); };
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
  LockstepRun run(simulation, endpoint, server);
  run.on_cut_cable = [&board](std::int64_t for_ns) { board.cut_cable(for_ns); };
  auto end = std::async(std::launch::async, [&run] { return run.run(); });
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
  EXPECT_EQ(end.get(), LockstepEnd::kHostGone);
  const StopReport report = run.run_without_host();
  EXPECT_EQ(report.last_grant_ns, 100 * kMs);
  EXPECT_EQ(report.stopped_after_ns, 200 * kMs);
  EXPECT_EQ(simulation.now_ns(), 2100 * kMs);
}

TEST_F(LockstepRunTest, WheelsThatGoOnAreReportedToo) {
  board.duty = {0.5, 0.5};
  EXPECT_EQ(run.run_without_host().stopped_after_ns, std::nullopt);
}

TEST_F(LockstepRunTest, RefusesWhatIsNoRequest) {
  auto end = start();
  channel.write("please 1\n");
  EXPECT_THROW(end.get(), std::runtime_error);
}

}  // namespace
}  // namespace echomap::runner
