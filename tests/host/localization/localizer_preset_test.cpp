// SPDX-License-Identifier: MIT
#include "host/localization/localizer_preset.hpp"

#include <cstdint>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/localization/polygon_view.hpp"
#include "host/mapping/polygon_map.hpp"
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
constexpr LocalizedRobot kRobot{
    .beam_half_angle_rad = 0.0, .max_range_m = 2.55, .body_radius_m = 0.1};
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
  LocalizedRobot blind;
  blind.max_range_m = 0.0;
  EXPECT_EQ(localizer_params(LocalizerPreset::kCreate, blind).hypotheses.bin_m,
            HypothesisParams().bin_m);
  blind.by = LocalizedBy::kContacts;
  blind.max_range_m = 0.1;  // Of its wall sensor.
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

/// A robot along the walls of the pillar's room, with a ring that sees 20 cm far.
TEST(LocalizerPreset, OursFindsARobotByItsRingOfInfrared) {
  const LocalizedRobot ring{.beam_half_angle_rad = 0.0,
                            .max_range_m = 0.2,
                            .by = LocalizedBy::kInfrared,
                            .body_radius_m = 0.1};
  const auto model = observation_model(LocalizerPreset::kDefault, kPillarRoom, ring);
  MonteCarloLocalizer localizer(
      *model, localizer_params(LocalizerPreset::kDefault, ring), std::mt19937(1));
  const PolygonView walls(*mapping::polygon_from_raster(kPillarRoom, {0.15, 0.08}),
                          {.max_range_m = 0.2});
  geometry::Pose2 T_map_robot(0.2, 0.25, 0.0);
  geometry::Pose2 T_odom_robot;
  const auto step = [&](const geometry::Pose2& T_last_now) {
    T_map_robot = T_map_robot * T_last_now;
    T_odom_robot = T_odom_robot * T_last_now;
    std::vector<RangeReading> readings;
    for (int i = 0; i < 8; ++i) {
      const geometry::Pose2 T_robot_sensor(0.0, 0.0, 0.25 * std::numbers::pi * i);
      const auto expected = walls.expected(T_map_robot * T_robot_sensor);
      readings.push_back({T_robot_sensor, expected.range_m});
    }
    localizer.update(T_odom_robot, readings);
  };
  for (int lap = 0; lap < 3; ++lap) {
    for (const double side_m : {1.7, 0.8, 1.7, 0.8}) {
      for (double travelled_m = 0.0; travelled_m < side_m; travelled_m += 0.1) {
        step({0.1, 0.0, 0.0});
      }
      step({0.0, 0.0, 0.5 * std::numbers::pi});
    }
  }
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.1, 0.2))
      << "half a turn away the walls are the same, but for the pillar";
}

TEST(LocalizerPreset, OursTakesContactsAndTheWallSensorBesideThem) {
  LocalizedRobot felt = kRobot;
  felt.by = LocalizedBy::kContacts;
  felt.max_range_m = 0.0;
  const auto contacts = observation_model(LocalizerPreset::kDefault, kPillarRoom, felt);
  felt.max_range_m = 0.1;
  const auto both = observation_model(LocalizerPreset::kDefault, kPillarRoom, felt);
  const std::vector<RangeReading> reading{{{}, 0.05}};
  contacts->observe(reading);
  both->observe(reading);
  EXPECT_EQ(contacts->count(), 1U);
  EXPECT_EQ(both->count(), 2U);
}

TEST(LocalizerPreset, CreateNeedsAnOutline) {
  EXPECT_THROW(observation_model(
                   LocalizerPreset::kCreate, mapping::RasterMap(5, 5, 0.1, {0.0, 0.0}), kRobot),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
