// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/range_sensor.hpp"

#include <gtest/gtest.h>

namespace echomap::ev3 {
namespace {

TEST(RangeSensor, UltrasonicTellsMillimetresAndNothingBeyondTwoAndAHalfMetres) {
  const RangeSensorFacts facts = facts_of(RangeSensor::kUltrasonic);
  EXPECT_EQ(facts.told(1.2344), 1234);
  EXPECT_EQ(facts.told(2.5), 2500);
  EXPECT_EQ(facts.told(2.6), 2550);
}

TEST(RangeSensor, NxtSonarTellsWholeCentimetres) {
  const RangeSensorFacts facts = facts_of(RangeSensor::kNxtSonar);
  EXPECT_EQ(facts.told(1.2344), 123);
  EXPECT_EQ(facts.told(2.6), 255);
}

TEST(RangeSensor, InfraredTellsPercentOfSeventyCentimetres) {
  const RangeSensorFacts facts = facts_of(RangeSensor::kInfrared);
  EXPECT_EQ(facts.told(0.35), 50);
  EXPECT_EQ(facts.told(0.071), 10);
  EXPECT_EQ(facts.told(0.8), 100);
}

}  // namespace
}  // namespace echomap::ev3
