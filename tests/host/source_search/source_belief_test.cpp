// SPDX-License-Identifier: MIT
#include "host/source_search/source_belief.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

using tests::SourceTruth;
using tests::SourceWorld;

SourceWorld small_room() { return SourceWorld({4.0, 3.0}, {}); }

/// What a robot counts that stands on each place of a lattice for so long.
std::vector<FieldReading> readings_of(const SourceWorld& world,
                                      const SourceTruth& truth,
                                      double spacing_m,
                                      double dwell_s) {
  std::mt19937 random(7);
  std::vector<FieldReading> readings;
  for (double y_m = 0.4; y_m < world.size_m().y(); y_m += spacing_m) {
    for (double x_m = 0.4; x_m < world.size_m().x(); x_m += spacing_m) {
      const double mean = dwell_s * world.rate(truth, {x_m, y_m}, 0.1);
      readings.push_back({{x_m, y_m}, tests::sample_poisson(mean, random), dwell_s, 0.01});
    }
  }
  return readings;
}

double sum_of(const mapping::CellField& field) {
  double sum = 0.0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    sum += static_cast<double>(field[i]);
  }
  return sum;
}

TEST(SourceBelief, BeginsWithThePrior) {
  SourceBeliefParams params;
  params.none_prior = 0.3;
  const SourceBelief belief(params, small_room().map());
  EXPECT_NEAR(belief.estimate().none_probability, 0.3, 1e-3);
  EXPECT_EQ(belief.estimate().verdict, SourceVerdict::kUndecided);
  EXPECT_NEAR(sum_of(belief.place_probability()), 0.7, 1e-3);
}

TEST(SourceBelief, FindsASourceAndItsStrength) {
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {2.63, 1.27};
  truth.strength = 5.0;
  SourceBelief belief({}, world.map());
  belief.add(readings_of(world, truth, 0.5, 5.0));
  const SourceEstimate& estimate = belief.estimate();
  EXPECT_EQ(estimate.verdict, SourceVerdict::kFound);
  EXPECT_LT((estimate.best_m - *truth.at_m).norm(), 0.1);
  EXPECT_NEAR(std::log(estimate.strength.median / 5.0), 0.0, 3.0 * estimate.strength.log_stddev);
  EXPECT_LT(estimate.strength.log_stddev, 0.2);
  EXPECT_NEAR(
      std::log(estimate.background.median / 0.4), 0.0, 3.0 * estimate.background.log_stddev);
  EXPECT_LT(estimate.radius_95_m, 0.25);
}

TEST(SourceBelief, FindsNothingOnAMapThatIsLost) {
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {2.63, 1.27};
  truth.strength = 5.0;
  SourceFloor floor(world.map());
  for (const double stddev_m : {0.05, 0.5}) {
    floor.position_stddev_m = stddev_m;
    SourceBelief belief({}, floor);
    belief.add(readings_of(world, truth, 0.5, 5.0));
    const bool is_placed = belief.estimate().within_probability >= 0.5;
    EXPECT_EQ(is_placed, stddev_m < 0.1);
    EXPECT_EQ(belief.estimate().verdict,
              is_placed ? SourceVerdict::kFound : SourceVerdict::kUndecided);
  }
}

TEST(SourceBelief, SaysThatThereIsNone) {
  const SourceWorld world = small_room();
  for (const double background : {0.1, 0.4, 3.0}) {
    SourceTruth truth;
    truth.background = background;
    SourceBelief belief({}, world.map());
    belief.add(readings_of(world, truth, 0.4, 10.0));
    EXPECT_EQ(belief.estimate().verdict, SourceVerdict::kNone) << background;
  }
}

TEST(SourceBelief, IsUndecidedWhereItHasNotBeen) {
  SourceBelief belief({}, small_room().map());
  const std::vector<FieldReading> readings{{{0.3, 0.3}, 2.0, 5.0, 0.01}};
  belief.add(readings);
  EXPECT_EQ(belief.estimate().verdict, SourceVerdict::kUndecided);
}

/// By the definition, on a grid that cannot be split, without interpolation or narrowed
/// backgrounds.
TEST(SourceBelief, IsBayesRule) {
  SourceBeliefParams params;
  params.grid.leaf_m = 0.5;
  params.grid.min_leaf_m = 0.5;
  params.grid.field.min_background = 0.3;
  params.grid.field.max_background = 0.6;
  params.grid.field.attenuations_per_m = {0.0};
  const SourceWorld world({1.0, 1.0}, {});
  mapping::RasterMap map(20, 20, 0.05, {0.0, 0.0});
  for (int i = 0; i < 400; ++i) {
    map.set({i % 20, i / 20}, mapping::CellState::kFree);
  }
  SourceBelief belief(params, map);
  const std::vector<FieldReading> readings{{{0.2, 0.2}, 3.0, 2.0, 0.0},
                                           {{0.8, 0.3}, 9.0, 2.0, 0.0}};
  belief.add(readings);

  const auto likelihood = [&](const Eigen::Vector2d* source_m, double strength, double background) {
    double log_sum = 0.0;
    for (const FieldReading& reading : readings) {
      const double distance_m = source_m != nullptr ? (reading.at_m - *source_m).norm() : 1.0;
      const double source = source_m != nullptr
                                ? 2.0 * strength * response(distance_m, 0.0, 0.0, params.grid.field)
                                : 0.0;
      const double variance =
          response_variance(distance_m, 0.0, 0.0, 0.25 / 12.0, params.grid.field);
      const double mean = source + 2.0 * background;
      const double excess = variance * source * source + 0.01 * 4.0 * background * background;
      const double dispersion = 1.0 + excess / mean;
      const double saturated = reading.value * std::log(reading.value) - reading.value;
      log_sum += (reading.value * std::log(mean) - mean - saturated) / dispersion -
                 0.5 * std::log(dispersion);
    }
    return std::exp(log_sum);
  };
  const auto marginal = [&](const Eigen::Vector2d* source_m) {
    double sum = 0.0;
    constexpr int kSteps = 60;
    for (int s = 0; s < kSteps; ++s) {
      for (int b = 0; b < kSteps; ++b) {
        sum += likelihood(
            source_m, std::pow(50.0, (s + 0.5) / kSteps), 0.3 * std::pow(2.0, (b + 0.5) / kSteps));
      }
    }
    return sum / (kSteps * kSteps);
  };
  const double none = 0.5 * marginal(nullptr);
  std::vector<double> places;
  for (const double y_m : {0.25, 0.75}) {
    for (const double x_m : {0.25, 0.75}) {
      const Eigen::Vector2d source_m(x_m, y_m);
      places.push_back(0.125 * marginal(&source_m));
    }
  }
  const double total = none + std::accumulate(places.begin(), places.end(), 0.0);
  EXPECT_NEAR(belief.estimate().none_probability, none / total, 0.01);
  const mapping::CellField field = belief.place_probability();
  EXPECT_NEAR(field[field.index({0, 0})], places[0] / total, 0.01);
  EXPECT_NEAR(field[field.index({1, 0})], places[1] / total, 0.01);
  EXPECT_NEAR(field[field.index({0, 1})], places[2] / total, 0.01);
  EXPECT_NEAR(field[field.index({1, 1})], places[3] / total, 0.01);
}

TEST(SourceBelief, OrderAndPortionsOfReadingsDoNotMatter) {
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {1.2, 2.0};
  std::vector<FieldReading> readings = readings_of(world, truth, 0.9, 3.0);
  SourceBelief one({}, world.map());
  one.add(readings);
  SourceBelief other({}, world.map());
  std::reverse(readings.begin(), readings.end());
  for (const FieldReading& reading : readings) {
    other.add(std::span(&reading, 1));
  }
  EXPECT_NEAR(one.estimate().none_probability, other.estimate().none_probability, 0.01);
  EXPECT_NEAR(one.estimate().within_probability, other.estimate().within_probability, 0.05);
}

TEST(SourceBelief, AWallExplainsWhyNothingIsReadBehindIt) {
  const SourceWorld world({4.0, 3.0}, {{{1.9, 0.0}, {2.1, 3.0}}});
  SourceTruth truth;
  SourceBelief belief({}, world.map());
  std::mt19937 random(3);
  std::vector<FieldReading> readings;
  for (const double y_m : {0.5, 1.5, 2.5}) {
    for (const double x_m : {0.5, 1.5}) {
      readings.push_back({{x_m, y_m}, tests::sample_poisson(0.4 * 20.0, random), 20.0, 0.01});
    }
  }
  belief.add(readings);
  const mapping::CellField field = belief.place_probability();
  double behind = 0.0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    behind += field.center_m(field.cell(i)).x() > 2.0 ? static_cast<double>(field[i]) : 0.0;
  }
  EXPECT_GT(behind, 0.9 * (1.0 - belief.estimate().none_probability));
}

TEST(SourceBelief, SamplesStandForThePosterior) {
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {2.63, 1.27};
  SourceBelief belief({}, world.map());
  belief.add(readings_of(world, truth, 1.2, 1.0));
  const auto samples = belief.sample(400, 0.5);
  ASSERT_EQ(samples.size(), 401U);
  double none = 0.0;
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  for (const SourceHypothesis& sample : samples) {
    none += sample.at_m ? 0.0 : sample.probability;
    mean_m += sample.probability * sample.at_m.value_or(Eigen::Vector2d::Zero());
  }
  EXPECT_NEAR(none, belief.estimate().none_probability, 0.01);
  const mapping::CellField field = belief.place_probability();
  Eigen::Vector2d expected_m = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < field.size(); ++i) {
    expected_m += static_cast<double>(field[i]) * field.center_m(field.cell(i));
  }
  EXPECT_LT((mean_m - expected_m).norm(), 0.05);
}

TEST(SourceBelief, FindsALampByALevel) {
  SourceBeliefParams params;
  params.grid.field.kind = SensorKind::kLevel;
  params.grid.field.level_stddev = 2.0;
  params.grid.field.standoff_m = 0.5;
  params.grid.field.min_strength = 5.0;
  params.grid.field.max_strength = 500.0;
  params.grid.field.min_background = 1.0;
  params.grid.field.max_background = 100.0;
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {2.9, 1.9};
  truth.strength = 60.0;
  truth.background = 20.0;
  SourceBelief belief(params, world.map());
  std::vector<FieldReading> readings;
  for (FieldReading reading : readings_of(world, truth, 0.6, 1.0)) {
    const double noise = static_cast<double>(readings.size() * 7 % 5) - 2.0;
    reading.value = world.rate(truth, reading.at_m, 0.5) + noise;
    reading.dwell_s = 0.0;
    readings.push_back(reading);
  }
  belief.add(readings);
  EXPECT_GT(belief.estimate().within_probability, 0.5);
  EXPECT_LT((belief.estimate().best_m - *truth.at_m).norm(), 0.3);
}

TEST(SourceBelief, StartsAgainOnAnotherMap) {
  const SourceWorld world = small_room();
  SourceTruth truth;
  truth.at_m = {2.63, 1.27};
  const auto readings = readings_of(world, truth, 0.5, 5.0);
  SourceBelief moved({}, SourceWorld({2.0, 2.0}, {}).map());
  moved.rebuild(world.map(), readings);
  SourceBelief direct({}, world.map());
  direct.add(readings);
  EXPECT_NEAR(moved.estimate().within_probability, direct.estimate().within_probability, 1e-6);
}

TEST(SourceBelief, RefusesWhatIsOutOfRange) {
  SourceBeliefParams params;
  params.none_prior = 1.0;
  EXPECT_THROW(SourceBelief(params, small_room().map()), std::invalid_argument);
  params = {};
  params.claim_probability = 0.4;
  EXPECT_THROW(SourceBelief(params, small_room().map()), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::source_search
