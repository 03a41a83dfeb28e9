// SPDX-License-Identifier: MIT
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/support/every_seed.hpp"
#include "tests/support/faulty_fleet.hpp"

namespace echomap::fleet {
namespace {

TEST(FleetOnABroker, EndsWithTheSameWhateverHappensToTheBroker) {
  const std::uint32_t seeds = tests::runs_every_seed() ? 40 : 3;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const tests::FaultyFleetRun run = tests::run_faulty_fleet(seed);
    ASSERT_TRUE(run.is_same) << "seed " << seed;
    EXPECT_GE(run.late_objects, tests::kMinFaultyFleetObjects) << "seed " << seed;
    EXPECT_LE(run.late_objects, tests::kMaxFaultyFleetObjects) << "seed " << seed;
    EXPECT_LT(run.bytes_per_s, 1000.0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace echomap::fleet
