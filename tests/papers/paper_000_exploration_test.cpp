// SPDX-License-Identifier: MIT
// Singh and Bedi 2013, section 3.2 and figure 6: an NXT explores its room by the farthest echoes.
// The shares over 20 seeds are told by `./run bench exploration --part papers`; here is one, on
// the image that a user flashes, and three in `./run test --full`.
#include <string>

#include <gtest/gtest.h>

#include "tests/papers/demo_run.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/exploration_case.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper000Exploration, EndsByItselfWithItsRoomOnTheReleaseFirmware) {
  const tests::ScratchFolder scratch;
  for (int seed = 1; seed <= (tests::runs_every_seed() ? 3 : 1); ++seed) {
    const auto report = run_demo(tests::demo_arguments(tests::nxt_in_its_room(), seed),
                                 scratch / std::to_string(seed));
    EXPECT_EQ(report.at("outcome").get<std::string>(), "no-new-ground") << seed;
    EXPECT_GE(report.at("free_iou"), 0.85) << seed;
    // By odometry alone, as in the paper: no stop is aligned. Aligned ones have 0.06.
    EXPECT_LE(report.at("wall_rmse_m"), 0.08) << seed;
  }
}

}  // namespace
}  // namespace echomap::papers
