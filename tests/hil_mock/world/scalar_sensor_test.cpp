// SPDX-License-Identifier: MIT
#include "hil_mock/world/scalar_sensor.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

constexpr double kStepS = 1e-3;

FloorPlan room_of(double background_per_s, double ambient_lux = 0.0) {
  FloorMarks marks;
  marks.backgrounds = {background_per_s, ambient_lux};
  return {"room", {rectangle(0.0, 0.0, 4.0, 3.0), {}}, {}, {1.0, 1.0, 0.0}, marks};
}

/// Times of the pulses in so many seconds.
std::vector<LowPulse> pulses_in(const FloorPlan& plan,
                                const ScalarSensorParams& params,
                                double seconds,
                                std::uint32_t seed = 1) {
  ScalarSensor sensor(plan, params, NoiseStream(seed, NoisePurpose::kScalarSensor));
  std::vector<LowPulse> all;
  const int steps = static_cast<int>(std::lround(seconds / kStepS));
  for (int i = 0; i < steps; ++i) {
    sensor.step(kStepS, {1.0, 1.0, 0.0});
    for (const LowPulse& pulse : sensor.pulses()) {
      EXPECT_GE(pulse.fall_s, 0.0);
      EXPECT_LT(pulse.fall_s, kStepS);
      all.push_back({i * kStepS + pulse.fall_s, i * kStepS + pulse.rise_s});
    }
  }
  return all;
}

TEST(ScalarSensor, PulsesAreAPoissonProcess) {
  const FloorPlan plan = room_of(20.0);
  ScalarSensorParams params;
  params.dead_time_s = 1e-6;
  params.pulse_s = 1e-7;
  constexpr int kSeconds = 2000;
  std::vector<int> each_s(kSeconds);
  const auto pulses = pulses_in(plan, params, kSeconds);
  for (const LowPulse& pulse : pulses) {
    ++each_s.at(static_cast<std::size_t>(pulse.fall_s));
  }
  const double mean = double(pulses.size()) / kSeconds;
  double sum = 0.0;
  for (const int count : each_s) {
    sum += (count - mean) * (count - mean);
  }
  EXPECT_NEAR(mean, 20.0, 4.0 * std::sqrt(20.0 / kSeconds));
  EXPECT_NEAR(sum / (kSeconds - 1) / mean, 1.0, 4.0 * std::sqrt(2.0 / kSeconds));
}

TEST(ScalarSensor, NoticesNothingInItsDeadTime) {
  const FloorPlan plan = room_of(2000.0);
  ScalarSensorParams params;
  const auto pulses = pulses_in(plan, params, 20.0);
  for (std::size_t i = 1; i < pulses.size(); ++i) {
    ASSERT_GE(pulses[i].fall_s - pulses[i - 1].fall_s, params.dead_time_s - 1e-12);
    ASSERT_NEAR(pulses[i].rise_s - pulses[i].fall_s, params.pulse_s, 1e-12);
  }
  const double expected_per_s = 2000.0 / (1.0 + 2000.0 * params.dead_time_s);
  EXPECT_NEAR(double(pulses.size()) / 20.0, expected_per_s, 0.02 * expected_per_s);
}

TEST(ScalarSensor, IsAFunctionOfItsSeed) {
  const FloorPlan plan = room_of(5.0);
  const auto once = pulses_in(plan, {}, 20.0, 7);
  const auto again = pulses_in(plan, {}, 20.0, 7);
  const auto other = pulses_in(plan, {}, 20.0, 8);
  ASSERT_EQ(once.size(), again.size());
  EXPECT_EQ(once.front().fall_s, again.front().fall_s);
  EXPECT_NE(once.front().fall_s, other.front().fall_s);
  EXPECT_TRUE(pulses_in(room_of(0.0), {}, 20.0).empty());
}

TEST(ScalarSensor, CountsWhatIsWhereItIsMounted) {
  FloorMarks marks;
  marks.sources = {{SourceKind::kRadiation, {2.0, 1.0}, 100.0, 0.1}};
  const FloorPlan plan("room", {rectangle(0.0, 0.0, 4.0, 3.0), {}}, {}, {1.0, 1.0, 0.0}, marks);
  ScalarSensorParams params;
  params.mount_m = {0.5, 0.0};
  params.sensitivity = 2.0;
  const double expected_per_s = 200.0 / (0.25 + 0.01);
  const double dead = 1.0 + expected_per_s * params.dead_time_s;
  EXPECT_NEAR(double(pulses_in(plan, params, 60.0).size()) / 60.0,
              expected_per_s / dead,
              0.03 * expected_per_s);
}

TEST(ScalarSensor, LightIsANoisyVoltage) {
  const FloorPlan plan = room_of(0.0, 100.0);
  ScalarSensorParams params;
  params.kind = ScalarSensorKind::kLight;
  params.sensitivity = 5.0;
  params.dark_millivolts = 40.0;
  params.noise_millivolts = 20.0;
  ScalarSensor sensor(plan, params, NoiseStream(1, NoisePurpose::kScalarSensor));
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSteps = 10000;
  for (int i = 0; i < kSteps; ++i) {
    sensor.step(kStepS, {1.0, 1.0, 0.0});
    sum += sensor.millivolts();
    squares += (sensor.millivolts() - 540.0) * (sensor.millivolts() - 540.0);
  }
  EXPECT_TRUE(sensor.pulses().empty());
  EXPECT_NEAR(sum / kSteps, 540.0, 1.0);
  EXPECT_NEAR(std::sqrt(squares / kSteps), 20.0, 1.0);
}

}  // namespace
}  // namespace echomap::world
