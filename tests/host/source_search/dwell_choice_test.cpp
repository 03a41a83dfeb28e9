// SPDX-License-Identifier: MIT
#include "host/source_search/dwell_choice.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

class DwellChoiceTest : public testing::Test {
 protected:
  DwellChoiceTest()
      : world_({10.0, 3.0}, {}),
        costs_(world_.map(), from_m_, {}),
        lattice_(costs_, 0.8),
        belief_({}, world_.map()) {}

  std::optional<DwellPlan> choose(const std::vector<PlannedDwell>& others) const {
    return DwellChoice({}).choose(belief_, costs_, lattice_, from_m_, others, std::nullopt, 0.3);
  }

  tests::SourceWorld world_;
  Eigen::Vector2d from_m_{5.0, 1.5};
  exploration::CostGrid costs_;
  DwellLattice lattice_;
  SourceBelief belief_;
};

TEST_F(DwellChoiceTest, PlansAWayWithReadings) {
  const auto plan = choose({});
  ASSERT_TRUE(plan);
  EXPECT_GT(plan->gain, 0.0);
  EXPECT_GT(plan->time_s, 0.0);
  double dwell_s = 0.0;
  for (const PlannedDwell& reading : plan->readings) {
    dwell_s += reading.dwell_s;
  }
  EXPECT_NEAR(dwell_s, plan->time_s, 1e-6);
  EXPECT_LT((plan->readings.back().at_m - plan->goal_m).norm(), 1e-9);
}

TEST_F(DwellChoiceTest, LeavesToOthersWhatTheyAreAboutToRead) {
  std::vector<PlannedDwell> left;
  std::vector<PlannedDwell> right;
  for (double x_m = 0.5; x_m < 4.8; x_m += 0.6) {
    for (const double y_m : {0.5, 1.5, 2.5}) {
      left.push_back({{x_m, y_m}, 10.0});
      right.push_back({{10.0 - x_m, y_m}, 10.0});
    }
  }
  EXPECT_GT(choose(left)->goal_m.x(), 5.0);
  EXPECT_LT(choose(right)->goal_m.x(), 5.0);
}

TEST_F(DwellChoiceTest, GoesToWhereTheSourceIsSupposed) {
  tests::SourceTruth truth;
  truth.at_m = {8.3, 1.4};
  truth.strength = 10.0;
  std::vector<FieldReading> readings;
  for (double x_m = 4.0; x_m <= 6.5; x_m += 0.5) {
    readings.push_back(
        {{x_m, 1.5}, std::round(5.0 * world_.rate(truth, {x_m, 1.5}, 0.1)), 5.0, 0.01});
  }
  belief_.add(readings);
  EXPECT_GT(choose({})->goal_m.x(), 6.0);
}

TEST_F(DwellChoiceTest, RefusesWhatIsOutOfRange) {
  DwellChoiceParams params;
  params.better = 0.5;
  EXPECT_THROW(DwellChoice{params}, std::invalid_argument);
  params = {};
  params.samples = 0;
  EXPECT_THROW(DwellChoice{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::source_search
