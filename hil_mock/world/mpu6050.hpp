// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hil_mock/world/rate_gyro.hpp"
#include "hil_mock/world/two_wire_device.hpp"

namespace echomap::world {

/// The registers of an MPU-6050 with AD0 low and its z axis up, as far as its yaw rate needs them:
/// CONFIG (filter), GYRO_CONFIG (full scale), GYRO_ZOUT, PWR_MGMT_1 and WHO_AM_I (InvenSense
/// RM-MPU-6000A rev. 4.2). All others read 0. It measures once a millisecond; a read of
/// GYRO_ZOUT_H holds the low byte for the read that follows.
class Mpu6050 final : public TwoWireDevice {
 public:
  static constexpr std::uint8_t kAddress = 0x68;

  /// Switched on: asleep, +-250 degrees/s, filter of 256 Hz.
  explicit Mpu6050(const RateGyro& gyro) : gyro_(gyro) {}

  /// Turns at `yaw_rad_per_s` for `dt_s`.
  void step(double dt_s, double yaw_rad_per_s);

  std::uint8_t address() const override { return kAddress; }
  void write(std::uint8_t device_register, std::uint8_t value) override;
  std::uint8_t read(std::uint8_t device_register) override;

  const RateGyro& gyro() const { return gyro_; }

 private:
  std::int16_t raw_yaw() const;

  RateGyro gyro_;
  std::uint8_t config_ = 0;
  std::uint8_t gyro_config_ = 0;
  std::uint8_t power_ = 0x40;
  std::uint8_t held_low_ = 0;
};

}  // namespace echomap::world
