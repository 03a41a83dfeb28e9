// SPDX-License-Identifier: MIT
#include "hil_mock/runner/paced_run.hpp"

#include <chrono>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/runner/pty_endpoint.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;

class PacedRun : public testing::TestWithParam<double> {};

TEST_P(PacedRun, ReachesItsEndExactlyAndServesTheHost) {
  const tests::ScratchFolder folder;
  FakeBoard board;
  world::RobotWorld world(world::box_room(), {}, 1);
  RobotSimulation simulation(board, world);
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kDrop);
  TestHost host = TestHost::open_terminal(endpoint.address());
  host.write("hello");
  RobotTeam team({&simulation});
  const ServedRobot robot{&simulation, &endpoint};
  run_paced(
      team, std::span(&robot, 1), Pacer(GetParam(), std::chrono::steady_clock::now()), kSecondNs);
  EXPECT_EQ(simulation.now_ns(), kSecondNs);
  EXPECT_EQ(host.read(5), "hello");
}

TEST(PacedTeam, EachRobotHearsItsOwnHost) {
  const tests::ScratchFolder folder;
  FakeBoard left_board;
  FakeBoard right_board;
  world::RobotWorld left_world(world::box_room({}, {1.0, 1.5, 0.0}), {}, 1);
  world::RobotWorld right_world(world::box_room({}, {3.0, 1.5, 0.0}), {}, 2);
  RobotSimulation left(left_board, left_world);
  RobotSimulation right(right_board, right_world);
  PtyEndpoint left_endpoint(folder / "left", WhenUnread::kDrop);
  PtyEndpoint right_endpoint(folder / "right", WhenUnread::kDrop);
  TestHost left_host = TestHost::open_terminal(left_endpoint.address());
  TestHost right_host = TestHost::open_terminal(right_endpoint.address());
  left_host.write("left");
  right_host.write("right");
  RobotTeam team({&left, &right});
  const std::vector<ServedRobot> robots{{&left, &left_endpoint}, {&right, &right_endpoint}};
  run_paced(team,
            robots,
            Pacer(std::numeric_limits<double>::infinity(), std::chrono::steady_clock::now()),
            kSecondNs);
  EXPECT_EQ(left.now_ns(), kSecondNs);
  EXPECT_EQ(right.now_ns(), kSecondNs);
  EXPECT_EQ(left_host.read(4), "left");
  EXPECT_EQ(right_host.read(5), "right");
}

INSTANTIATE_TEST_SUITE_P(Speeds,
                         PacedRun,
                         testing::Values(20.0, std::numeric_limits<double>::infinity()));

}  // namespace
}  // namespace echomap::runner
