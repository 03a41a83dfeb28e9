// SPDX-License-Identifier: MIT
// Mahmood and Ridao 2017, section 4: an e-puck covers its field along walls and obstacles under a
// camera, and the grid is made of what its infra-red ring saw. More seeds: `./run bench
// exploration`.
#include <string>

#include <gtest/gtest.h>

#include "tests/papers/demo_run.hpp"
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

TEST_F(Paper002Exploration, CoversItsFieldOnTheReleaseFirmware) {
  expect_field(cover(tests::epuck_on_its_field(), 1));
}

TEST_F(Paper002Exploration, CoversItsFieldWithOtherWheels) {
  auto on_the_mock = tests::epuck_on_its_field();
  on_the_mock.board.clear();
  expect_field(cover(on_the_mock, 2));
}

}  // namespace
}  // namespace echomap::papers
