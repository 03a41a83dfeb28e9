// SPDX-License-Identifier: MIT
#include "host/sensors/scalar_meter.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

using protocol::Scalar;

ScalarParams level_params() {
  ScalarParams params;
  params.kind = ScalarKind::kLevel;
  params.zero = -10.0;
  params.full_scale = 90.0;
  return params;
}

TEST(ScalarMeter, CountsPulsesBetweenMessages) {
  ScalarMeter meter({});
  EXPECT_FALSE(meter.update(Scalar{1'000'000, 0, 0, 500, 0})) << "nobody knows since when";
  const auto reading = meter.update(Scalar{1'100'000, 0, 0, 507, 0});
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->count, 7.0);
  EXPECT_NEAR(reading->dwell_s, 0.1, 1e-12);
}

TEST(ScalarMeter, LosesNoPulseWithItsMessages) {
  std::mt19937 random(5);
  ScalarMeter meter({});
  Scalar message{0xFFFF0000, 0, 0, 0xFFFFFF00, 0};
  meter.update(message);
  double counted = 0.0;
  double dwell_s = 0.0;
  for (int i = 0; i < 1000; ++i) {
    message.stamp_us += 100'000;
    message.sum += static_cast<std::uint32_t>(random() % 100);
    const bool is_lost = i != 999 && random() % 3 != 0;
    const auto reading = is_lost ? std::nullopt : meter.update(message);
    counted += reading ? reading->count : 0.0;
    dwell_s += reading ? reading->dwell_s : 0.0;
  }
  const std::uint32_t pulses = message.sum - 0xFFFFFF00;
  EXPECT_EQ(counted, double(pulses)) << "through the wraps of sum and stamp";
  EXPECT_NEAR(dwell_s, 100.0, 1e-9);
}

TEST(ScalarMeter, TakesTheMeanOfALevelInItsUnit) {
  ScalarMeter meter(level_params());
  meter.update(Scalar{0, 0, 0, 0xFFFFFFFF, 65'500});
  const auto reading = meter.update(Scalar{100'000, 0, 0, 99U * 1023U / 2U - 1U, 63});
  ASSERT_TRUE(reading);
  EXPECT_NEAR(reading->count, 40.0, 0.01);
  EXPECT_EQ(reading->dwell_s, 0.0);
  EXPECT_FALSE(meter.update(Scalar{200'000, 0, 0, 50'638, 63})) << "nothing was converted";
}

TEST(ScalarMeter, PassesOverWhatComesTwiceOrOutOfOrder) {
  ScalarMeter meter({});
  meter.update(Scalar{1'000, 0, 0, 10, 0});
  EXPECT_FALSE(meter.update(Scalar{1'000, 0, 0, 10, 0}));
  EXPECT_FALSE(meter.update(Scalar{900, 0, 0, 8, 0}));
  EXPECT_EQ(meter.update(Scalar{2'000, 0, 0, 12, 0})->count, 2.0);
}

TEST(ScalarMeter, BeginsAnewAfterAResetAndAfterAMinute) {
  ScalarMeter meter({});
  meter.update(Scalar{1'000, 0, 0, 10, 0});
  meter.restart();
  EXPECT_FALSE(meter.update(Scalar{900, 0, 0, 3, 0}));
  EXPECT_EQ(meter.update(Scalar{1'900, 0, 0, 4, 0})->count, 1.0);
  EXPECT_FALSE(meter.update(Scalar{60'001'900, 0, 0, 400, 0}));
  EXPECT_EQ(meter.update(Scalar{60'101'900, 0, 0, 402, 0})->count, 2.0);
}

TEST(ScalarMeter, RefusesParametersThatMeanNothing) {
  ScalarParams params;
  params.dead_time_s = -1e-6;
  EXPECT_THROW(ScalarMeter{params}, std::invalid_argument);
  params = {};
  params.background_per_s = -0.1;
  EXPECT_THROW(ScalarMeter{params}, std::invalid_argument);
  params = level_params();
  params.full_scale = params.zero;
  EXPECT_THROW(ScalarMeter{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors
