// SPDX-License-Identifier: MIT
#include "host/source_search/source_layer.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

/// Of a source at (2.63, 1.27), read all over the room.
SourceBelief belief_of_a_source() {
  const tests::SourceWorld world({4.0, 3.0}, {});
  tests::SourceTruth truth;
  truth.at_m = {2.63, 1.27};
  std::mt19937 random(5);
  std::vector<FieldReading> readings;
  for (double y_m = 0.4; y_m < 3.0; y_m += 0.5) {
    for (double x_m = 0.4; x_m < 4.0; x_m += 0.5) {
      const double mean = 5.0 * world.rate(truth, {x_m, y_m}, 0.1);
      readings.push_back({{x_m, y_m}, tests::sample_poisson(mean, random), 5.0, 0.01});
    }
  }
  SourceBelief belief({}, world.map());
  belief.add(readings);
  return belief;
}

TEST(SourceLayer, DensityHoldsTheProbabilityOfASource) {
  const SourceBelief belief = belief_of_a_source();
  const mapping::CellField density = source_density(belief, 0.2);
  double sum = 0.0;
  std::size_t densest = 0;
  for (std::size_t i = 0; i < density.size(); ++i) {
    sum += static_cast<double>(density[i]) * 0.04;
    densest = density[i] > density[densest] ? i : densest;
  }
  EXPECT_NEAR(sum, 1.0 - belief.estimate().none_probability, 1e-3);
  EXPECT_LT((density.center_m(density.cell(densest)) - Eigen::Vector2d(2.63, 1.27)).norm(), 0.25);
}

TEST(SourceLayer, ExpectedRateIsThatOfTheSourceAndTheBackground) {
  const mapping::CellField rate = expected_rate(belief_of_a_source(), 0.1);
  const auto at = [&](double x_m, double y_m) {
    return static_cast<double>(rate[rate.index(rate.cell_at({x_m, y_m}))]);
  };
  EXPECT_NEAR(at(2.63, 2.25), 5.4, 1.5);
  EXPECT_NEAR(at(0.15, 0.15), 5.0 / 7.4 + 0.4, 0.4);
}

TEST(SourceLayer, RefusesCellsWithoutSize) {
  EXPECT_THROW(source_density(belief_of_a_source(), 0.0), std::invalid_argument);
}

TEST(SourceLayer, JsonSaysWhatIsKnown) {
  const SourceBelief belief = belief_of_a_source();
  const auto json = nlohmann::json::parse(source_json(belief.estimate(), belief.params()));
  EXPECT_EQ(json.at("verdict"), "found");
  EXPECT_NEAR(json.at("best_m").at(0).get<double>(), 2.63, 0.15);
  EXPECT_GE(json.at("within_probability").get<double>(), 0.95);
  EXPECT_LE(json.at("none_probability").get<double>(), 0.05);
  EXPECT_NEAR(json.at("strength").at("median").get<double>(), 5.0, 1.5);
  EXPECT_GT(json.at("radius_95_m").get<double>(), 0.0);
  EXPECT_EQ(json.at("unit"), "pulses per second");
}

TEST(SourceLayer, JsonHasNoStrengthBeforeAnyPlaceIsKnown) {
  const auto json = nlohmann::json::parse(source_json({}, {}));
  EXPECT_TRUE(json.at("strength").is_null());
  EXPECT_EQ(json.at("verdict"), "undecided");
}

}  // namespace
}  // namespace echomap::source_search
