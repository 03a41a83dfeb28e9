// SPDX-License-Identifier: MIT
#include "host/source_search/probable_disc.hpp"

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

using mapping::CellField;

CellField empty_field() { return CellField({{-10, -10}, {29, 19}}, 0.05); }

void put(CellField& field, const Eigen::Vector2d& at_m, float probability) {
  field[field.index(field.cell_at(at_m))] += probability;
}

TEST(ProbableDisc, TakesWhatLiesTogetherBeforeWhatIsLargeAlone) {
  CellField field = empty_field();
  put(field, {-0.2, -0.2}, 0.3F);
  put(field, {1.0, 0.5}, 0.25F);
  put(field, {1.1, 0.5}, 0.25F);
  const ProbableDisc disc = most_probable_disc(field, 0.2);
  EXPECT_NEAR(disc.probability, 0.5, 1e-6);
  EXPECT_LT((disc.middle_m - Eigen::Vector2d(1.05, 0.5)).norm(), 0.11);
}

TEST(ProbableDisc, HasNothingWhereThereIsNothing) {
  EXPECT_EQ(most_probable_disc(empty_field(), 0.2).probability, 0.0);
  EXPECT_EQ(radius_with_share_m(empty_field(), {0.0, 0.0}, 0.95), 0.0);
}

TEST(ProbableDisc, RadiusHoldsTheShare) {
  CellField field = empty_field();
  put(field, {0.01, 0.01}, 0.6F);
  put(field, {0.31, 0.0}, 0.3F);
  put(field, {0.91, 0.0}, 0.1F);
  const Eigen::Vector2d middle_m = field.center_m(field.cell_at({0.01, 0.01}));
  EXPECT_NEAR(radius_with_share_m(field, middle_m, 0.5), 0.0, 1e-9);
  EXPECT_NEAR(radius_with_share_m(field, middle_m, 0.85), 0.3, 1e-6);
  EXPECT_NEAR(radius_with_share_m(field, middle_m, 0.95), 0.9, 1e-6);
}

TEST(ProbableDisc, AnErrorOfAllPlacesSpreadsThem) {
  CellField field = empty_field();
  field[field.index({0, 0})] = 1.0F;
  const Eigen::Vector2d middle_m = field.center_m({0, 0});
  EXPECT_NEAR(sum_in_disc(with_error(field, 0.0), middle_m, 0.2), 1.0, 1e-6);
  // Rayleigh: 1 - exp(-r^2 / (2 stddev^2)).
  EXPECT_NEAR(sum_in_disc(with_error(field, 0.1), middle_m, 0.2), 0.865, 0.06);
  EXPECT_NEAR(radius_with_share_m(with_error(field, 0.1), middle_m, 0.95), 0.245, 0.04);
}

}  // namespace
}  // namespace echomap::source_search
