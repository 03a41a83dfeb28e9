// SPDX-License-Identifier: MIT
#include "host/localization/localizer_preset.hpp"

#include <cstdint>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"
#include "tests/support/expect_pose_estimate.hpp"

namespace echomap::localization {
namespace {

/// 2 x 1.2 m, with a pillar that breaks its symmetry.
const mapping::RasterMap kPillarRoom = tests::map_from({"######################",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#..###...............#",
                                                        "#..###...............#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "#....................#",
                                                        "######################"},
                                                       0.1);
constexpr LocalizedRobot kRobot{0.0, 2.55, false, 0.1};
const geometry::Pose2 kTruth(1.45, 0.55, 0.4);

/// Eight exact ranges from the truth, a centimetre a step.
std::vector<RangeReading> look_around() {
  std::vector<RangeReading> readings;
  for (int i = 0; i < 8; ++i) {
    const geometry::Pose2 T_robot_sensor(0.0, 0.0, 0.25 * std::numbers::pi * i);
    const geometry::Pose2 T_map_sensor = kTruth * T_robot_sensor;
    double range_m = 0.0;
    while (kPillarRoom.state(kPillarRoom.cell_at(T_map_sensor * Eigen::Vector2d(range_m, 0.0))) ==
           mapping::CellState::kFree) {
      range_m += 0.01;
    }
    readings.push_back({T_robot_sensor, range_m});
  }
  return readings;
}

class RangePresets : public testing::TestWithParam<LocalizerPreset> {};
INSTANTIATE_TEST_SUITE_P(All,
                         RangePresets,
                         testing::Values(LocalizerPreset::kDefault,
                                         LocalizerPreset::kNxt,
                                         LocalizerPreset::kEpuck));

TEST_P(RangePresets, FollowARobotThatLooksAround) {
  const auto model = observation_model(GetParam(), kPillarRoom, kRobot);
  MonteCarloLocalizer localizer(*model, localizer_params(GetParam(), kRobot), std::mt19937(1));
  localizer.update({}, {});
  // A quarter of a metre and 0.3 rad off.
  localizer.start_at({1.25, 0.7, 0.1}, 0.25, 0.3);
  for (int i = 0; i < 10; ++i) {
    localizer.update({}, look_around());
  }
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), kTruth, 0.12, 0.12));
}

TEST(LocalizerPreset, PapersKeepTheirNumberOfParticles) {
  const auto particles_after = [](LocalizerPreset preset) {
    const auto model = observation_model(preset, kPillarRoom, kRobot);
    MonteCarloLocalizer localizer(*model, localizer_params(preset, kRobot), std::mt19937(1));
    localizer.update({}, look_around());
    localizer.update({0.01, 0.0, 0.0}, look_around());
    return localizer.particles().size();
  };
  EXPECT_EQ(particles_after(LocalizerPreset::kNxt), 250U);
  EXPECT_EQ(particles_after(LocalizerPreset::kEpuck), 1000U);
  EXPECT_EQ(particles_after(LocalizerPreset::kCreate), 1000U);
}

TEST(LocalizerPreset, CreateIsFoundByWhatItFeels) {
  const auto model = observation_model(LocalizerPreset::kCreate, kPillarRoom, kRobot);
  MonteCarloLocalizer localizer(
      *model, localizer_params(LocalizerPreset::kCreate, kRobot), std::mt19937(1));
  localizer.update({}, {});
  localizer.start_at({1.7, 0.6, 0.0}, 0.3, 0.05);
  model->add_contact({true, true, true});  // At the right wall, whose inside is at 2.1 m.
  localizer.update({}, {});
  ASSERT_FALSE(localizer.belief().hypotheses.empty());
  EXPECT_NEAR(localizer.belief().hypotheses[0].T_map_robot.x_m(), 2.0, 0.08);
}

TEST(LocalizerPreset, ARobotWithoutRangesHasWholeBins) {
  const LocalizedRobot blind{0.0, 0.0, false, 0.1};
  EXPECT_EQ(localizer_params(LocalizerPreset::kCreate, blind).hypotheses.bin_m,
            HypothesisParams().bin_m);
}

TEST(LocalizerPreset, NxtSeesAWallOfCellsThatMeetInCorners) {
  mapping::RasterMap map(40, 40, 0.1, {0.0, 0.0});
  for (std::int32_t i = 0; i < 40; ++i) {
    map.set({i, 39 - i}, mapping::CellState::kOccupied);
  }
  const auto model = observation_model(LocalizerPreset::kNxt, map, kRobot);
  const RangeReading heard{{}, 1.0};
  model->observe(std::span(&heard, 1));
  Particles particles;
  particles.resize(2);
  // A metre before a cell's middle, and as far before the wall between two.
  const double aside_m = 0.65 * 0.1 * std::numbers::sqrt2 / 2.0;
  const Eigen::Vector2d before_m =
      Eigen::Vector2d(2.05, 1.95) - Eigen::Vector2d::Constant(std::numbers::sqrt2 / 2.0);
  particles.set_pose(0, {before_m.x(), before_m.y(), 0.25 * std::numbers::pi});
  particles.set_pose(1, {before_m.x() + aside_m, before_m.y() - aside_m, 0.25 * std::numbers::pi});
  particles.log_weight = {0.0F, 0.0F};
  model->update_weights(1.0F, {0, 2}, particles);
  EXPECT_NEAR(particles.log_weight[0], particles.log_weight[1], 0.1F);
}

TEST(LocalizerPreset, CreateNeedsAnOutline) {
  EXPECT_THROW(observation_model(
                   LocalizerPreset::kCreate, mapping::RasterMap(5, 5, 0.1, {0.0, 0.0}), kRobot),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
