// SPDX-License-Identifier: MIT
// Mahmood and Ridao 2017, section 4: an e-puck covers its field along walls and obstacles under a
// camera, and the grid is made of what its infra-red ring saw. More seeds: `./run bench
// exploration`.
#include <string>

#include <gtest/gtest.h>

#include "tests/papers/demo_run.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/exploration_case.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

class Paper002Exploration : public ::testing::Test {
 protected:
  nlohmann::json cover(const tests::ExplorationCase& what, int seed) {
    return run_demo(tests::demo_arguments(what, seed), scratch_ / std::to_string(seed));
  }

  tests::ScratchFolder scratch_;
};

void expect_field(const nlohmann::json& report) {
  EXPECT_EQ(report.at("outcome"), "complete");
  EXPECT_LE(report.at("wall_rmse_m"), 0.010);
  EXPECT_GE(report.at("wall_recall"), 0.95);
  EXPECT_GE(report.at("free_iou"), 0.8);
}

// On the image that a user flashes, too, in `./run test --full`.
TEST_F(Paper002Exploration, CoversItsField) {
  auto on_the_mock = tests::epuck_on_its_field();
  on_the_mock.board.clear();
  expect_field(cover(on_the_mock, 2));
  if (tests::runs_every_seed()) {
    expect_field(cover(tests::epuck_on_its_field(), 1));
  }
}

}  // namespace
}  // namespace echomap::papers
