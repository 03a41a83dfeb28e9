// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/i2c.hpp"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

class Memory final : public world::TwoWireDevice {
 public:
  std::uint8_t address() const override { return 0x68; }
  void write(std::uint8_t device_register, std::uint8_t value) override {
    bytes.at(device_register) = value;
  }
  std::uint8_t read(std::uint8_t device_register) override { return bytes.at(device_register); }

  std::array<std::uint8_t, 256> bytes{};
};

class I2cWithAMemory : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kCr1 = 0x00;
  static constexpr std::uint32_t kCr2 = 0x04;
  static constexpr std::uint32_t kDr = 0x10;
  static constexpr std::uint32_t kSr1 = 0x14;
  static constexpr std::uint32_t kSr2 = 0x18;
  static constexpr std::uint32_t kCcr = 0x1C;

  static constexpr std::uint32_t kOn = 1U << 0;
  static constexpr std::uint32_t kStart = 1U << 8;
  static constexpr std::uint32_t kStop = 1U << 9;
  static constexpr std::uint32_t kAcknowledge = 1U << 10;
  static constexpr std::uint32_t kSecondByte = 1U << 11;
  static constexpr std::uint32_t kStarted = 1U << 0;
  static constexpr std::uint32_t kAddressed = 1U << 1;
  static constexpr std::uint32_t kByteEnded = 1U << 2;
  static constexpr std::uint32_t kNoAnswer = 1U << 10;
  static constexpr std::uint32_t kBusy = 1U << 1;

  /// 400 kbit/s of 36 MHz.
  static constexpr std::uint32_t kFast = (1U << 15) | 30;
  static constexpr std::uint64_t kBitCycles = 180;
  static constexpr std::uint64_t kByteCycles = 9 * kBitCycles;

  I2cWithAMemory() {
    i2c.reset();
    i2c.has_pins = [this] { return has_pins; };
    i2c.connect(memory);
    i2c.write(kCcr, kFast);
    i2c.write(kCr1, kOn);
  }

  bool shows(std::uint32_t flag) { return (i2c.read(kSr1) & flag) != 0; }
  void wait(std::uint64_t cycles) { queue.skip_to(queue.now() + cycles); }
  void start(std::uint32_t more = 0) {
    i2c.write(kCr1, kOn | kStart | more);
    wait(kBitCycles);
  }
  /// True where somebody answers.
  bool call(std::uint8_t address_byte) {
    EXPECT_TRUE(shows(kStarted));
    i2c.write(kDr, address_byte);
    wait(kByteCycles);
    const bool answered = shows(kAddressed);
    i2c.read(kSr2);
    return answered;
  }
  void send(std::uint8_t byte) {
    i2c.write(kDr, byte);
    wait(kByteCycles);
    EXPECT_TRUE(shows(kByteEnded));
  }
  bool stops() {
    i2c.write(kCr1, kOn | kStop);
    wait(2 * kBitCycles);
    return (i2c.read(kSr2) & kBusy) == 0;
  }

  EventQueue queue;
  Nvic nvic;
  Memory memory;
  bool has_pins = true;
  I2c i2c{queue, nvic};
};

TEST_F(I2cWithAMemory, WritesARegister) {
  start();
  ASSERT_TRUE(call(0xD0));
  send(0x1B);
  send(0x08);
  EXPECT_TRUE(stops());
  EXPECT_EQ(memory.bytes[0x1B], 0x08);
}

TEST_F(I2cWithAMemory, ReadsTwoBytesOfWhichTheSecondIsRefused) {
  memory.bytes[0x47] = 0x12;
  memory.bytes[0x48] = 0x34;
  start();
  ASSERT_TRUE(call(0xD0));
  send(0x47);
  start(kAcknowledge | kSecondByte);
  ASSERT_TRUE(call(0xD1));
  i2c.write(kCr1, kOn | kSecondByte);
  wait(2 * kByteCycles);
  ASSERT_TRUE(shows(kByteEnded));
  EXPECT_EQ(i2c.read(kDr), 0x12U);
  EXPECT_EQ(i2c.read(kDr), 0x34U);
  EXPECT_TRUE(stops());
}

TEST_F(I2cWithAMemory, AByteAcknowledgedTooManyHoldsTheBus) {
  start();
  ASSERT_TRUE(call(0xD0));
  send(0x47);
  start(kAcknowledge | kSecondByte);
  ASSERT_TRUE(call(0xD1));
  wait(2 * kByteCycles);  // and ACK still stands
  ASSERT_TRUE(shows(kByteEnded));
  EXPECT_FALSE(stops());
}

TEST_F(I2cWithAMemory, NobodyAnswersAtAnotherAddress) {
  i2c.write(kCr2, 1U << 8);
  start();
  EXPECT_FALSE(call(0xD2));
  EXPECT_TRUE(shows(kNoAnswer));
  i2c.write(kSr1, 0);
  EXPECT_FALSE(shows(kNoAnswer));
  EXPECT_TRUE(stops());
}

TEST_F(I2cWithAMemory, NothingMovesWithoutItsPins) {
  has_pins = false;
  start();
  EXPECT_FALSE(shows(kStarted));
}

TEST_F(I2cWithAMemory, SwitchedOffItForgetsWhatIsUnderWay) {
  start();
  i2c.write(kDr, 0xD0);
  i2c.write(kCr1, 0);
  i2c.write(kCr1, kOn);
  wait(kByteCycles);
  EXPECT_EQ(i2c.read(kSr1), 0U);
}

}  // namespace
}  // namespace echomap::unicorn
