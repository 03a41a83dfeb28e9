// SPDX-License-Identifier: MIT
#include "host/localization/range_update.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

const mapping::RasterMap kHollowBlockRoom = tests::map_from({"####################",
                                                             "#..................#",
                                                             "#..................#",
                                                             "#.......####.......#",
                                                             "#.......#  #.......#",
                                                             "#.......####.......#",
                                                             "#..................#",
                                                             "#..................#",
                                                             "####################"},
                                                            0.1,
                                                            {-1.0, -0.5});
const models::BeamModel kModel(models::sonar_cone_returns());

struct KernelScene {
  RangeTable table{kHollowBlockRoom, {0.2, 4.0}};
  LikelihoodCodes likelihoods{table, kModel};

  float weight(const Pose2& pose, const std::vector<RangeReading>& readings) {
    Particles particles;
    particles.resize(1);
    particles.set_pose(0, pose);
    const CodedReadings coded(readings, table, likelihoods);
    fill_under(particles, coded, table);
    update_weights(table, coded, 1.0F, {0, 1}, particles);
    return particles.log_weight[0];
  }

  /// By the table and the model, without the kernel.
  double literal(const Pose2& pose, const RangeReading& reading) {
    const Pose2 T_map_sensor = pose * reading.T_robot_sensor;
    const Eigen::Vector2d cells = (T_map_sensor.position_m() - table.origin_m()) / 0.1;
    const geometry::CellIndex cell{static_cast<std::int32_t>(std::floor(cells.x())),
                                   static_cast<std::int32_t>(std::floor(cells.y()))};
    const long heading =
        std::lround(T_map_sensor.heading_rad() / (2.0 * std::numbers::pi) * RangeTable::kHeadings);
    table.fill_tile(table.tile_of(cell));
    const std::uint8_t expected = table.codes_at(cell)[static_cast<std::size_t>(
        (heading + 2L * RangeTable::kHeadings) % RangeTable::kHeadings)];
    const std::uint8_t read = table.code_of({reading.range_m, false});
    return std::log(
        kModel.likelihood(table.expected_of(read).range_m, table.expected_of(expected)));
  }
};

TEST(RangeUpdate, AddsTheLogarithmsOfTheModel) {
  KernelScene scene;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Pose2 pose(-0.7 + 0.4 * any(random), -0.35 + 0.55 * any(random), 6.0 * any(random));
    std::vector<RangeReading> readings;
    double expected = 0.0;
    for (int k = 0; k < 5; ++k) {
      const Pose2 T_robot_sensor(0.05 * (k % 2), 0.0, geometry::radians(7.03125 * k));
      readings.push_back({T_robot_sensor, k == 3 ? std::nullopt : std::optional(any(random))});
    }
    for (const RangeReading& reading : readings) {
      expected += scene.literal(pose, reading);
    }
    // A heading on the border of two may fall to either, as may a place.
    const auto ours = static_cast<double>(scene.weight(pose, readings));
    ASSERT_NEAR(ours, expected, 0.03) << i;
  }
}

TEST(RangeUpdate, RulesOutWhereNoRobotStands) {
  KernelScene scene;
  const std::vector<RangeReading> readings{{{}, 0.5}, {{0.0, 0.0, 1.0}, std::nullopt}};
  for (const Pose2& nowhere :
       {Pose2(0.0, -0.05, 0.0), Pose2(50.0, 0.0, 0.0), Pose2(0.0, -50.0, 1.0)}) {
    EXPECT_LT(scene.weight(nowhere, readings), -50.0F);
  }
  EXPECT_GT(scene.weight({-0.5, 0.0, 0.0}, readings), -20.0F);
}

TEST(RangeUpdate, PassesOverReadingsThatAreNoNumbers) {
  KernelScene scene;
  const std::vector<RangeReading> none{{{}, std::numeric_limits<double>::quiet_NaN()},
                                       {{}, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(scene.weight({-0.5, 0.0, 0.0}, none), 0.0F);
}

TEST(RangeUpdate, ComesToTheSameBitsHoweverTheParticlesAreSharedOut) {
  KernelScene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Particles whole;
  whole.resize(777);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    whole.set_pose(i, {any(random), 0.4 * any(random), 3.0 * any(random)});
  }
  const std::vector<RangeReading> readings{{{0.1, 0.02, 0.3}, 0.5}, {{0.1, 0.02, 1.0}, 0.7}};
  const CodedReadings coded(readings, scene.table, scene.likelihoods);
  fill_under(whole, coded, scene.table);
  Particles parts = whole;
  update_weights(scene.table, coded, 0.25F, {0, 777}, whole);
  for (const ParticleRange range : {ParticleRange{0, 300}, {300, 301}, {301, 777}}) {
    update_weights(scene.table, coded, 0.25F, range, parts);
  }
  EXPECT_EQ(whole.log_weight, parts.log_weight);
}

}  // namespace
}  // namespace echomap::localization
