// SPDX-License-Identifier: MIT
#include "host/models/range_likelihood.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

static_assert(RangeLikelihood<BeamModel>);

const BeamModel kSonar(sonar_cone_returns_in_own_map());

/// The integral over all ranges and the chance of no return.
double total(const BeamModel& model, const ExpectedRange& expected) {
  constexpr double kStepM = 1e-3;
  double sum = model.likelihood(std::nullopt, expected);
  for (double range_m = 0.5 * kStepM; range_m < 4.0; range_m += kStepM) {
    sum += kStepM * model.likelihood(range_m, expected);
  }
  return sum;
}

TEST(BeamModel, IsADensityWhateverIsExpected) {
  for (const BeamModel& model : {BeamModel(sonar_cone_returns()), kSonar}) {
    for (const double expected_m : {0.5, 1.0, 2.0, 3.5}) {
      EXPECT_NEAR(total(model, {expected_m, false}), 1.0, 0.01) << expected_m;
      EXPECT_NEAR(total(model, {expected_m, true}), 1.0, 0.01) << expected_m;
    }
    for (const double edge_m : {0.05, 0.15, 0.5, 2.0, 3.8}) {
      EXPECT_NEAR(total(model, {edge_m, false, true}), 1.0, 0.01) << edge_m;
    }
    EXPECT_NEAR(total(model, {}), 1.0, 0.01);
  }
}

TEST(BeamModel, FindsTheExpectedRangeLikeliest) {
  for (const double range_m : {0.5, 1.5, 1.9, 2.1, 3.0}) {
    EXPECT_GT(kSonar.likelihood(2.0, {2.0}), kSonar.likelihood(range_m, {2.0})) << range_m;
  }
}

TEST(BeamModel, TakesSilenceForAHintAtNothing) {
  EXPECT_GT(kSonar.likelihood(std::nullopt, {}), 0.5);
  EXPECT_GT(kSonar.likelihood(std::nullopt, {2.0}), 0.0);
  EXPECT_LT(kSonar.likelihood(std::nullopt, {2.0}), kSonar.likelihood(std::nullopt, {}));
}

TEST(BeamModel, TrustsLessInWhatIsSeenAslant) {
  const ExpectedRange straight{2.0, false};
  const ExpectedRange aslant{2.0, true};
  EXPECT_GT(kSonar.likelihood(2.0, straight), kSonar.likelihood(2.0, aslant));
  EXPECT_LT(kSonar.likelihood(3.0, straight), kSonar.likelihood(3.0, aslant));
  EXPECT_LT(kSonar.likelihood(std::nullopt, straight), kSonar.likelihood(std::nullopt, aslant));
}

TEST(BeamModel, SaysLittleOfWhatIsBeyondTheKnownFloor) {
  const ExpectedRange unseen{1.0, false, true};
  const double silent = kSonar.likelihood(std::nullopt, unseen);
  EXPECT_GT(silent, 0.2);
  EXPECT_LT(silent, 0.6);
  EXPECT_GT(kSonar.likelihood(1.1, unseen), kSonar.likelihood(2.0, unseen));
  EXPECT_GT(kSonar.likelihood(2.5, unseen), kSonar.likelihood(2.5, {}));
  EXPECT_LT(kSonar.likelihood(0.5, unseen), kSonar.likelihood(2.0, unseen));
}

TEST(BeamModel, RefusesChancesThatLeaveNoHit) {
  const auto refuses = [](auto&& set) {
    BeamModelParams params;
    set(params);
    EXPECT_THROW(BeamModel{params}, std::invalid_argument);
  };
  refuses([](BeamModelParams& params) { params.short_chance = params.missed_chance = 0.5; });
  refuses([](BeamModelParams& params) { params.oblique_missed_chance = 1.0; });
  refuses([](BeamModelParams& params) { params.silent_chance = -0.1; });
  refuses([](BeamModelParams& params) { params.unseen_silent_chance = 0.9; });
  refuses([](BeamModelParams& params) { params.unseen_edge_chance = -0.1; });
  refuses([](BeamModelParams& params) { params.unseen_edge_stddev_m = 0.0; });
  refuses([](BeamModelParams& params) { params.hit_stddev_m = 0.0; });
  refuses([](BeamModelParams& params) { params.max_range_m = 0.0; });
}

}  // namespace
}  // namespace echomap::models
