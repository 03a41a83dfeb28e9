// SPDX-License-Identifier: MIT
#include "hil_mock/runner/paced_run.hpp"

#include <chrono>
#include <limits>

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
  run_paced(simulation, endpoint, Pacer(GetParam(), std::chrono::steady_clock::now()), kSecondNs);
  EXPECT_EQ(simulation.now_ns(), kSecondNs);
  EXPECT_EQ(host.read(5), "hello");
}

INSTANTIATE_TEST_SUITE_P(Speeds,
                         PacedRun,
                         testing::Values(20.0, std::numeric_limits<double>::infinity()));

}  // namespace
}  // namespace echomap::runner
