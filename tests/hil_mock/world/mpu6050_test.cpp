// SPDX-License-Identifier: MIT
#include "hil_mock/world/mpu6050.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

Mpu6050 turning(double yaw_rad_per_s) {
  Mpu6050 chip(RateGyro({0.0, 0.0, 0.0, 0.0}, NoiseStream(1, NoisePurpose::kGyro)));
  for (int i = 0; i < 100; ++i) {
    chip.step(0.001, yaw_rad_per_s);
  }
  return chip;
}

int yaw(Mpu6050& chip) {
  const unsigned high = chip.read(0x47);
  const unsigned low = chip.read(0x48);
  return static_cast<std::int16_t>(high << 8U | low);
}

TEST(Mpu6050, SleepsUntilItIsWoken) {
  Mpu6050 chip = turning(1.0);
  EXPECT_EQ(chip.read(0x75), 0x68);
  EXPECT_EQ(chip.read(0x6B), 0x40);
  EXPECT_EQ(yaw(chip), 0);
  chip.write(0x6B, 0x01);
  EXPECT_EQ(yaw(chip), std::lround(57.29578 * 131.0));
}

TEST(Mpu6050, CountsByItsFullScale) {
  const double counts_per_deg_per_s[] = {131.0, 65.5, 32.8, 16.4};
  for (unsigned scale = 0; scale < 4; ++scale) {
    Mpu6050 chip = turning(-1.0);
    chip.write(0x6B, 0);
    chip.write(0x1B, static_cast<std::uint8_t>(scale << 3U));
    EXPECT_EQ(yaw(chip), -std::lround(57.29578 * counts_per_deg_per_s[scale])) << scale;
  }
}

TEST(Mpu6050, StopsAtItsFullScale) {
  Mpu6050 fast = turning(10.0);
  fast.write(0x6B, 0);
  EXPECT_EQ(yaw(fast), 32767);
  fast.write(0x1B, 3U << 3U);
  EXPECT_EQ(yaw(fast), std::lround(572.9578 * 16.4));
}

TEST(Mpu6050, TheLowByteBelongsToTheHighOneThatWasRead) {
  Mpu6050 chip = turning(0.5);
  chip.write(0x6B, 0);
  const unsigned high = chip.read(0x47);
  for (int i = 0; i < 50; ++i) {
    chip.step(0.001, 2.0);
  }
  const unsigned low = chip.read(0x48);
  EXPECT_EQ(high << 8U | low, std::lround(28.64789 * 131.0));
}

TEST(Mpu6050, ItsFilterIsThatOfConfig) {
  Mpu6050 slow = turning(0.0);
  slow.write(0x6B, 0);
  slow.write(0x1A, 6);
  slow.step(0.001, 1.0);
  EXPECT_LT(yaw(slow), 0.04 * 57.3 * 131.0) << "5 Hz";
  slow.write(0x6B, 0x80);
  EXPECT_EQ(slow.read(0x1A), 0);
  EXPECT_EQ(slow.read(0x6B), 0x40);
}

}  // namespace
}  // namespace echomap::world
