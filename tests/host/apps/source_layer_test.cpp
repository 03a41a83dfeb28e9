// SPDX-License-Identifier: MIT
#include "host/apps/source_layer.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::apps {
namespace {

TEST(SourceLayer, HasItsBrightestCellAtTheSource) {
  const tests::SourceWorld world({4.0, 3.0}, {});
  tests::SourceTruth truth;
  const Eigen::Vector2d source_m(2.63, 1.27);
  truth.at_m = source_m;
  std::mt19937 random(5);
  std::vector<source_search::FieldReading> readings;
  for (double y_m = 0.4; y_m < 3.0; y_m += 0.5) {
    for (double x_m = 0.4; x_m < 4.0; x_m += 0.5) {
      const double mean = 5.0 * world.rate(truth, {x_m, y_m}, 0.1);
      readings.push_back({{x_m, y_m}, tests::sample_poisson(mean, random), 5.0, 0.01});
    }
  }
  source_search::SourceBelief belief({}, world.map());
  belief.add(readings);
  const live_page::TeamSource shown = shown_source(belief);
  const auto brightest = std::ranges::max_element(shown.field->cells);
  ASSERT_EQ(*brightest, 255);
  const auto cell = static_cast<int>(brightest - shown.field->cells.begin());
  const auto columns = static_cast<int>(shown.field->columns);
  const int row = cell / columns;
  const Eigen::Vector2d in_cells(cell % columns + 0.5, row + 0.5);
  const Eigen::Vector2d at_m = shown.field->origin_m + shown.field->resolution_m * in_cells;
  EXPECT_LT((at_m - source_m).norm(), 0.25);
  EXPECT_EQ(shown.verdict, "found");
  ASSERT_TRUE(shown.at_m);
  EXPECT_LT((*shown.at_m - source_m).norm(), 0.2);
}

}  // namespace
}  // namespace echomap::apps
