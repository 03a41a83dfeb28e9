// SPDX-License-Identifier: MIT
#include "host/localization/correlation_model.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

/// 20 x 10 cm in cells of 1 cm.
const mapping::RasterMap kField = tests::map_from({"####################",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "#..................#",
                                                   "####################"},
                                                  0.01);

CorrelationModelParams params() {
  CorrelationModelParams params;
  params.cell_m = 0.005;
  params.sector.thickness_m = 0.01;
  params.sector.max_range_m = 0.06;
  params.sector.beam_width_rad = 0.2;
  return params;
}

double log_weight_at(const std::vector<RangeReading>& readings, const geometry::Pose2& pose) {
  CorrelationModel model(kField, params());
  model.observe(readings);
  EXPECT_EQ(model.count(), 1U);
  Particles particles;
  particles.resize(1);
  particles.set_pose(0, pose);
  model.update_weights(1.0F, {0, 1}, particles);
  return static_cast<double>(particles.log_weight[0]);
}

const std::vector<RangeReading> kWallAhead{{{}, 0.035}};
const std::vector<RangeReading> kNothing(1);

TEST(CorrelationModel, AWallThatIsSeenIsInTheMap) {
  const double at_the_wall = log_weight_at(kWallAhead, {0.16, 0.05, 0.0});
  EXPECT_GT(at_the_wall, -0.4);
  EXPECT_LT(log_weight_at(kWallAhead, {0.10, 0.05, 0.0}), at_the_wall - 0.7);
  EXPECT_LT(log_weight_at(kWallAhead, {0.18, 0.05, 0.0}), at_the_wall - 0.3);
}

TEST(CorrelationModel, AWallThatIsNotSeenIsNotInTheMap) {
  EXPECT_EQ(log_weight_at(kNothing, {0.10, 0.05, 0.0}), 0.0);
  EXPECT_NEAR(log_weight_at(kNothing, {0.16, 0.05, 0.0}), std::log(0.3), 1e-6);
}

TEST(CorrelationModel, NoReadingSaysNothing) {
  CorrelationModel model(kField, params());
  model.observe({});
  EXPECT_EQ(model.count(), 0U);
  model.observe(std::vector<RangeReading>{{{}, std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_EQ(model.count(), 0U);
}

TEST(CorrelationModel, RefusesSettingsWithoutSense) {
  CorrelationModelParams bad = params();
  bad.cell_m = 0.0;
  EXPECT_THROW(CorrelationModel(kField, bad), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
