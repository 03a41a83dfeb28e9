// SPDX-License-Identifier: MIT
#include "host/models/map_correlation.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

using Cells = std::vector<std::pair<double, double>>;  // Of the map and of the local map.

MapCorrelation correlation_of(const Cells& cells) {
  MapCorrelation correlation;
  for (const auto& [map, local] : cells) {
    correlation.add(map, local);
  }
  return correlation;
}

/// Equations 6.35 and 6.36 as they are printed.
double as_printed(const Cells& cells) {
  double mean = 0.0;
  for (const auto& [map, local] : cells) {
    mean += (map + local) / (2.0 * static_cast<double>(cells.size()));
  }
  double top = 0.0;
  double map_part = 0.0;
  double local_part = 0.0;
  for (const auto& [map, local] : cells) {
    top += (map - mean) * (local - mean);
    map_part += (map - mean) * (map - mean);
    local_part += (local - mean) * (local - mean);
  }
  return top / std::sqrt(map_part * local_part);
}

TEST(MapCorrelation, IsThatOfTheBook) {
  for (const Cells& cells : {Cells{{0.0, 0.0}, {1.0, 1.0}, {0.5, 1.0}, {0.2, 0.0}},
                             Cells{{1.0, 0.0}, {0.0, 1.0}, {0.3, 0.9}},
                             Cells{{0.0, 0.1}, {0.0, 0.2}, {0.0, 0.9}, {1.0, 0.4}}}) {
    EXPECT_NEAR(correlation_of(cells).value(), as_printed(cells), 1e-12);
  }
}

TEST(MapCorrelation, IsOneForEqualMapsAndMinusOneForOpposites) {
  EXPECT_NEAR(correlation_of({{0.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}}).value(), 1.0, 1e-12);
  EXPECT_NEAR(correlation_of({{0.0, 1.0}, {1.0, 0.0}}).value(), -1.0, 1e-12);
}

TEST(MapCorrelation, AgreesOnAnEmptyFloor) {
  EXPECT_EQ(correlation_of({{0.0, 0.0}, {0.0, 0.0}}).value(), 1.0);
  EXPECT_EQ(MapCorrelation().value(), 1.0);
}

TEST(MapCorrelation, DoesNotAgreeWhereOnlyOneSeesAWall) {
  EXPECT_LE(correlation_of({{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}}).value(), 0.0);
  EXPECT_LE(correlation_of({{0.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}}).value(), 0.0);
}

TEST(CorrelationLikelihood, IsNeverLessThanItsLeast) {
  const CorrelationLikelihood model({.least = 0.1});
  EXPECT_EQ(model.likelihood(correlation_of({{0.0, 1.0}, {1.0, 0.0}})), 0.1);
  EXPECT_EQ(model.likelihood(correlation_of({{0.0, 0.0}})), 1.0);
}

TEST(CorrelationLikelihood, RefusesALeastWithoutSense) {
  EXPECT_THROW(CorrelationLikelihood({.least = 0.0}), std::invalid_argument);
  EXPECT_THROW(CorrelationLikelihood({.least = 1.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
