// SPDX-License-Identifier: MIT
#include "hil_mock/world/mpu6050.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echomap::world {
namespace {

enum Register : std::uint8_t {
  kConfig = 0x1A,
  kGyroConfig = 0x1B,
  kGyroZoutH = 0x47,
  kGyroZoutL = 0x48,
  kPowerManagement1 = 0x6B,
  kWhoAmI = 0x75,
};

constexpr unsigned kDeviceReset = 0x80;
constexpr unsigned kSleep = 0x40;

/// Of the gyro, by DLPF_CFG; the last value is reserved.
constexpr std::array<double, 8> kBandwidthHz = {256.0, 188.0, 98.0, 42.0, 20.0, 10.0, 5.0, 256.0};
/// By FS_SEL.
constexpr std::array<double, 4> kCountsPerDegPerS = {131.0, 65.5, 32.8, 16.4};

}  // namespace

void Mpu6050::step(double dt_s, double yaw_rad_per_s) {
  gyro_.step(dt_s, yaw_rad_per_s, kBandwidthHz[config_ & 7U]);
}

void Mpu6050::write(std::uint8_t device_register, std::uint8_t value) {
  switch (device_register) {
    case kConfig:
      config_ = value;
      break;
    case kGyroConfig:
      gyro_config_ = value;
      break;
    case kPowerManagement1:
      power_ = value;
      if ((value & kDeviceReset) != 0) {
        *this = Mpu6050(gyro_);
      }
      break;
    default:
      break;
  }
}

std::uint8_t Mpu6050::read(std::uint8_t device_register) {
  switch (device_register) {
    case kConfig:
      return config_;
    case kGyroConfig:
      return gyro_config_;
    case kPowerManagement1:
      return power_;
    case kWhoAmI:
      return kAddress;
    case kGyroZoutH: {
      const auto raw = static_cast<std::uint16_t>(raw_yaw());
      held_low_ = static_cast<std::uint8_t>(raw & 0xFFU);
      return static_cast<std::uint8_t>(raw >> 8U);
    }
    case kGyroZoutL:
      return held_low_;
    default:
      return 0;
  }
}

std::int16_t Mpu6050::raw_yaw() const {
  if ((power_ & kSleep) != 0) {
    return 0;
  }
  const double counts = gyro_.rate_deg_per_s() * kCountsPerDegPerS[(gyro_config_ >> 3U) & 3U];
  return static_cast<std::int16_t>(std::lround(std::clamp(counts, -32768.0, 32767.0)));
}

}  // namespace echomap::world
