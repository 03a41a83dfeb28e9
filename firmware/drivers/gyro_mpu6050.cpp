// SPDX-License-Identifier: MIT
#include "firmware/drivers/gyro_mpu6050.hpp"

#include "firmware/hal/twi.hpp"

namespace echomap {
namespace drivers {
namespace {

/// Registers by "MPU-6000 and MPU-6050 Register Map and Descriptions", InvenSense RM-MPU-6000A-00.
constexpr uint8_t kAddress = 0x68;
constexpr uint8_t kConfig = 0x1A;
constexpr uint8_t kLowPass42Hz = 3;
constexpr uint8_t kGyroConfig = 0x1B;
constexpr uint8_t kRangeShift = 3;
constexpr uint8_t kGyroZOut = 0x47;
constexpr uint8_t kPowerManagement = 0x6B;
constexpr uint8_t kAwakeOnGyroClock = 3;

/// Transfers of the set-up, the first read, and every other one.
enum Step : uint8_t { kWake, kFilter, kRange, kFirstRead, kReading };

}  // namespace

void GyroMpu6050::restart() {
  hal::stop_twi();
  step_ = kWake;
  rate_ = 0;
}

void GyroMpu6050::tick(const protocol::ConfigureSensors& settings) {
  if (settings.gyro_period_ms != 0 && ++age_ms_ >= settings.gyro_period_ms) {
    age_ms_ = 0;
    sample(settings.gyro_range);
  }
}

void GyroMpu6050::sample(uint8_t range) {
  int16_t rate = 0;
  const bool done = hal::twi_state(rate) == hal::TwiState::kDone;
  if (done && step_ == kReading) {
    rate_ = rate;
  } else {
    ++errors_;
  }
  if (!done) {
    hal::stop_twi();
    step_ = kWake;
  }
  ++samples_;
  yaw_sum_ += rate_;
  start_transfer(range);
}

void GyroMpu6050::start_transfer(uint8_t range) {
  switch (step_) {
    case kWake:
      hal::start_twi_write(kAddress, kPowerManagement, kAwakeOnGyroClock);
      break;
    case kFilter:
      hal::start_twi_write(kAddress, kConfig, kLowPass42Hz);
      break;
    case kRange:
      hal::start_twi_write(kAddress, kGyroConfig, static_cast<uint8_t>(range << kRangeShift));
      break;
    default:
      hal::start_twi_read(kAddress, kGyroZOut);
      step_ = kReading;
      return;
  }
  ++step_;
}

}  // namespace drivers
}  // namespace echomap
