// SPDX-License-Identifier: MIT
#include "host/papers/epuck_ring.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "host/papers/epuck_field.hpp"

namespace echomap::papers {
namespace {

using Readings = std::vector<localization::RangeReading>;

/// Readings of a robot that has stood there for a second.
Readings readings_at(const geometry::Pose2& T_world_robot) {
  EpuckRing ring(epuck_field(), 1);
  Readings readings;
  for (int i = 0; i < 10; ++i) {
    readings = ring.read(T_world_robot);
  }
  return readings;
}

TEST(EpuckRing, HasEightSensorsOnTheHull) {
  const auto places = EpuckRing(epuck_field(), 1).places();
  ASSERT_EQ(places.size(), 8U);
  for (const geometry::Pose2& T_robot_sensor : places) {
    EXPECT_NEAR(T_robot_sensor.position_m().norm(), kEpuckRadiusM, 0.01);
  }
}

TEST(EpuckRing, MeasuresTheWallBesideTheRobotAndNothingInTheOpen) {
  const Readings beside = readings_at({0.2, 0.05, 0.0});
  const auto nearest = std::ranges::min_element(
      beside, {}, [](const auto& reading) { return reading.range_m.value_or(1.0); });
  ASSERT_TRUE(nearest->range_m);
  EXPECT_LT(*nearest->range_m, 0.03);
  EXPECT_LT(nearest->T_robot_sensor.position_m().y(), 0.0) << "the wall is to the right";
  const Readings open = readings_at({0.25, 0.3, 0.0});
  EXPECT_TRUE(
      std::ranges::none_of(open, [](const auto& reading) { return reading.range_m.has_value(); }));
}

}  // namespace
}  // namespace echomap::papers
