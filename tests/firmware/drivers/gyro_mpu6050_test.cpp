// SPDX-License-Identifier: MIT
#include "firmware/drivers/gyro_mpu6050.hpp"

#include <map>

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "firmware/hal/twi.hpp"

namespace echomap::drivers {
namespace {

/// An MPU-6050 that sleeps after power-up, as the real one does.
class GyroMpu6050Test : public testing::Test {
 protected:
  GyroMpu6050Test() {
    board.power_on();
    power_up();
    board.two_wire.on_write = [this](std::uint8_t address, std::uint8_t to, std::uint8_t value) {
      registers[to] = value;
      return connected && address == 0x68;
    };
    board.two_wire.on_read = [this](std::uint8_t address, std::uint8_t from) {
      const bool awake = (registers[0x6B] & 0x40) == 0;
      const bool is_z = address == 0x68 && from == 0x47;
      return connected && is_z ? std::optional<std::int16_t>(awake ? rate : 0) : std::nullopt;
    };
  }
  ~GyroMpu6050Test() override { board.two_wire = native::NativeTwoWire(); }

  void power_up() { registers = {{0x6B, 0x40}, {0x1A, 0}, {0x1B, 0}}; }
  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      board.run_until_ns(board.now_ns() + 1000000);
      gyro.tick(settings);
    }
  }

  native::NativeBoard& board = native::NativeBoard::instance();
  std::map<std::uint8_t, std::uint8_t> registers;
  bool connected = true;
  std::int16_t rate = -321;
  protocol::ConfigureSensors settings{0, 0, 10, 1};
  GyroMpu6050 gyro;
};

/// Three writes and the first read, whose word is there at the end of the next period.
constexpr int kSetUpSamples = 4;

TEST_F(GyroMpu6050Test, WakesItAndSetsRangeAndFilter) {
  run_ms(100);
  EXPECT_EQ(registers[0x6B], 3) << "awake, on the clock of the z gyro";
  EXPECT_EQ(registers[0x1A], 3) << "44 Hz";
  EXPECT_EQ(registers[0x1B], 1 << 3) << "500 degrees/s";
}

TEST_F(GyroMpu6050Test, SumsOneSampleAPeriod) {
  run_ms(1000);
  EXPECT_EQ(gyro.samples(), 100);
  EXPECT_EQ(gyro.errors(), kSetUpSamples);
  EXPECT_EQ(gyro.yaw_sum(), -321 * (100 - kSetUpSamples));
  const std::int32_t before = gyro.yaw_sum();
  rate = 32767;
  run_ms(10);
  rate = 1000;
  run_ms(10);
  EXPECT_EQ(gyro.yaw_sum() - before, -321 + 32767) << "each is read in the period before";
}

TEST_F(GyroMpu6050Test, IsSilentWhileSwitchedOff) {
  settings.gyro_period_ms = 0;
  run_ms(100);
  EXPECT_EQ(gyro.samples(), 0);
  EXPECT_EQ(registers[0x6B], 0x40);
}

TEST_F(GyroMpu6050Test, LastGoodSampleStandsInForThoseThatFail) {
  run_ms(500);
  const std::int32_t before = gyro.yaw_sum();
  connected = false;
  run_ms(50);
  EXPECT_EQ(gyro.errors(), kSetUpSamples + 4) << "the first of them was still read";
  EXPECT_EQ(gyro.samples(), 55);
  EXPECT_EQ(gyro.yaw_sum() - before, -321 * 5);
}

TEST_F(GyroMpu6050Test, SetsUpAnewADeviceThatCameBack) {
  run_ms(500);
  connected = false;
  run_ms(100);
  power_up();
  connected = true;
  rate = 77;
  run_ms(60);
  const std::uint16_t errors = gyro.errors();
  const std::int32_t before = gyro.yaw_sum();
  EXPECT_EQ(registers[0x1B], 1 << 3);
  run_ms(100);
  EXPECT_EQ(gyro.errors(), errors);
  EXPECT_EQ(gyro.yaw_sum() - before, 77 * 10);
}

TEST_F(GyroMpu6050Test, GivesUpABusThatIsHeldAndTriesAgain) {
  run_ms(500);
  board.two_wire.held = true;
  run_ms(100);
  EXPECT_EQ(gyro.errors(), kSetUpSamples + 9);
  board.two_wire.held = false;
  run_ms(60);
  const std::uint16_t errors = gyro.errors();
  run_ms(100);
  EXPECT_EQ(gyro.errors(), errors);
}

TEST_F(GyroMpu6050Test, KeepsUpWithItsShortestPeriod) {
  settings.gyro_period_ms = 2;
  run_ms(1000);
  EXPECT_EQ(gyro.samples(), 500);
  EXPECT_EQ(gyro.errors(), kSetUpSamples);
}

TEST_F(GyroMpu6050Test, RestartForgetsTheRateOfTheOldRange) {
  run_ms(500);
  connected = false;
  settings.gyro_range = 3;
  gyro.restart();
  const std::int32_t before = gyro.yaw_sum();
  run_ms(1000);
  EXPECT_EQ(gyro.yaw_sum(), before) << "an unplugged gyro does not turn for ever";
}

TEST_F(GyroMpu6050Test, RestartLetsTheBusGo) {
  run_ms(500);
  gyro.restart();
  std::int16_t value = 0;
  EXPECT_EQ(hal::twi_state(value), hal::TwiState::kIdle);
}

TEST_F(GyroMpu6050Test, RefusesAPeriodInWhichATransferMayNotEnd) {
  settings.gyro_period_ms = 1;
  EXPECT_FALSE(GyroMpu6050::accepts(settings));
  settings.gyro_period_ms = 2;
  EXPECT_TRUE(GyroMpu6050::accepts(settings));
}

TEST_F(GyroMpu6050Test, RefusesARangeThatItHasNot) {
  settings.gyro_range = 3;
  EXPECT_TRUE(GyroMpu6050::accepts(settings));
  settings.gyro_range = 4;
  EXPECT_FALSE(GyroMpu6050::accepts(settings));
}

}  // namespace
}  // namespace echomap::drivers
