// SPDX-License-Identifier: MIT
#include "hil_mock/world/ir_range.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

using geometry::radians;

NoiseStream range_noise() { return {1, NoisePurpose::kRange0}; }

/// 2 m before the right wall of the box room, plus what is asked for.
geometry::Pose2 before_wall(double range_m, double heading_rad = 0.0) {
  return {4.0 - range_m, 1.5, heading_rad};
}

double mean_mv(const FloorPlan& plan, IrKind kind, const geometry::Pose2& T_world_sensor) {
  IrRange sensor(plan, {0, kind, {}}, range_noise());
  double sum_mv = 0.0;
  for (int i = 0; i < 2000; ++i) {
    sensor.step(0.05, T_world_sensor);
    sum_mv += sensor.millivolts();
  }
  return sum_mv / 2000.0;
}

TEST(IrRange, TheSharpGivesTheVoltagesOfItsDataSheet) {
  EXPECT_NEAR(ir_millivolts(IrKind::kGp2y0a21, {0.10, 0.9, 0.0}), 2300.0, 1.0);
  EXPECT_NEAR(ir_millivolts(IrKind::kGp2y0a21, {0.80, 0.9, 0.0}), 400.0, 1.0);
  const double between_mv = ir_millivolts(IrKind::kGp2y0a21, {0.27, 0.9, 0.0});
  EXPECT_LT(between_mv, 1070.0);
  EXPECT_GT(between_mv, 910.0);
}

TEST(IrRange, TheSharpIsBlindToTheColourAndTakesANearWallForAFarOne) {
  EXPECT_EQ(ir_millivolts(IrKind::kGp2y0a21, {0.3, 0.2, 0.0}),
            ir_millivolts(IrKind::kGp2y0a21, {0.3, 0.9, 0.0}));
  EXPECT_LT(ir_millivolts(IrKind::kGp2y0a21, {0.03, 0.9, 0.0}),
            ir_millivolts(IrKind::kGp2y0a21, {0.10, 0.9, 0.0}));
}

TEST(IrRange, ReflectedLightFallsWithRangeColourAndIncidence) {
  const auto epuck_mv = [](const IrTarget& target) {
    return ir_millivolts(IrKind::kEpuck, target);
  };
  EXPECT_NEAR(epuck_mv({0.01, 0.9, 0.0}), 2500.0, 1.0) << "half at its half range";
  EXPECT_NEAR(epuck_mv({0.06, 0.9, 0.0}) / epuck_mv({0.03, 0.9, 0.0}), 0.27, 0.01);
  EXPECT_NEAR(epuck_mv({0.03, 0.45, 0.0}), 0.5 * epuck_mv({0.03, 0.9, 0.0}), 1e-9);
  EXPECT_LT(epuck_mv({0.03, 0.9, radians(40.0)}), 0.15 * epuck_mv({0.03, 0.9, 0.0}))
      << "only almost perpendicular walls";
}

TEST(IrRange, MeasuresTheRoomFromItsPlaceOnTheRobot) {
  const FloorPlan plan = box_room();
  IrRange sensor(plan, {0, IrKind::kGp2y0a21, {0.05, 0.0, radians(90.0)}}, range_noise());
  double sum_mv = 0.0;
  for (int i = 0; i < 1000; ++i) {
    sensor.step(0.05, {2.0, 2.5, 0.0});
    sum_mv += sensor.millivolts();
  }
  EXPECT_NEAR(sum_mv / 1000.0, 600.0, 2.0) << "the wall is 0.5 m to the left";
}

TEST(IrRange, SeesADarkWallWorse) {
  const FloorPlan bright = box_room();
  const FloorPlan dark("dark",
                       {rectangle(0.0, 0.0, 4.0, 3.0), std::vector<Surface>(4, {{}, 0.3})},
                       {},
                       {2.0, 1.5, 0.0});
  const double bright_mv = mean_mv(bright, IrKind::kEpuck, before_wall(0.02));
  EXPECT_NEAR(mean_mv(dark, IrKind::kEpuck, before_wall(0.02)), bright_mv / 3.0, 2.0);
}

TEST(IrRange, NoiseIsOfItsSizeAndRepeats) {
  const FloorPlan plan = box_room();
  IrRange first(plan, {0, IrKind::kEpuck, {}}, range_noise());
  IrRange second(plan, {0, IrKind::kEpuck, {}}, range_noise());
  double sum_of_squares = 0.0;
  const double mean = mean_mv(plan, IrKind::kEpuck, before_wall(0.03));
  for (int i = 0; i < 4000; ++i) {
    first.step(0.01, before_wall(0.03));
    second.step(0.01, before_wall(0.03));
    ASSERT_EQ(first.millivolts(), second.millivolts());
    sum_of_squares += std::pow(first.millivolts() - mean, 2);
  }
  EXPECT_NEAR(std::sqrt(sum_of_squares / 4000.0), 10.0, 0.5);
}

TEST(IrRange, TheOutputStandsStillBetweenTwoMeasurements) {
  const FloorPlan plan = box_room();
  IrRange sensor(plan, {0, IrKind::kGp2y0a21, {}}, range_noise());
  int changes = 0;
  double last_mv = -1.0;
  for (int i = 0; i < 1000; ++i) {
    sensor.step(0.001, before_wall(0.3));
    changes += sensor.millivolts() != last_mv ? 1 : 0;
    last_mv = sensor.millivolts();
  }
  EXPECT_NEAR(changes, 1000.0 / 38.3, 1.5) << "38.3 ms each";
}

TEST(IrRange, SeesAPaneStraightOnAndAlmostNotAtAll) {
  const auto walled = [](Material material) {
    return FloorPlan("box",
                     {rectangle(0.0, 0.0, 4.0, 3.0), {{}, {material}}},
                     {},
                     geometry::Pose2(2.0, 1.5, 0.0));
  };
  const FloorPlan glass = walled(Material::kGlass);
  const FloorPlan paint = walled(Material::kSmooth);
  const auto share = [&](double heading_rad) {
    const auto at = before_wall(0.02, heading_rad);
    return mean_mv(glass, IrKind::kCreateWall, at) / mean_mv(paint, IrKind::kCreateWall, at);
  };
  EXPECT_NEAR(share(0.0), 0.08 / 0.9, 0.02);
  EXPECT_LT(share(radians(20.0)), 0.01);
}

}  // namespace
}  // namespace echomap::world
