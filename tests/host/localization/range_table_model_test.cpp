// SPDX-License-Identifier: MIT
#include "host/localization/range_table_model.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "tests/host/localization/corridor.hpp"

namespace echomap::localization {
namespace {

RangeTableModel corridor_model() {
  return {RangeTable(kCorridor, {0.0, 4.0}), models::BeamModel(models::laser_returns())};
}

Particles one_at(const geometry::Pose2& pose) {
  Particles particles;
  particles.resize(1);
  particles.set_pose(0, pose);
  particles.log_weight[0] = 0.0F;
  return particles;
}

float weight_at(double x_m, RangeTableModel& model) {
  Particles particles = one_at({x_m, 0.2, 0.0});
  model.make_ready(particles, Workers());
  model.update_weights(1.0F, {0, 1}, particles);
  return particles.log_weight[0];
}

TEST(RangeTableModel, WeighsByTheSweepThatWasObservedLast) {
  RangeTableModel model = corridor_model();
  const RangeReading far{{}, 1.7};
  const RangeReading near{{}, 0.7};
  model.observe(std::span(&far, 1));
  EXPECT_GT(weight_at(1.2, model), weight_at(2.2, model) + 1.0F);
  model.observe(std::span(&near, 1));
  EXPECT_GT(weight_at(2.2, model), weight_at(1.2, model) + 1.0F);
}

TEST(RangeTableModel, CountsWhatSaysSomething) {
  RangeTableModel model = corridor_model();
  const std::array<RangeReading, 3> readings{
      {{{}, 1.0}, {{}, std::nullopt}, {{}, std::numeric_limits<double>::quiet_NaN()}}};
  model.observe(readings);
  EXPECT_EQ(model.count(), 2U);
}

TEST(RangeTableModel, LeavesWeightsAloneBeforeItHasObserved) {
  RangeTableModel model = corridor_model();
  EXPECT_EQ(weight_at(1.2, model), 0.0F);
}

}  // namespace
}  // namespace echomap::localization
