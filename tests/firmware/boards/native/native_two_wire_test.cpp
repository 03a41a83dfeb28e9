// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_two_wire.hpp"

#include <gtest/gtest.h>

namespace echomap::native {
namespace {

using hal::TwiState;

TEST(NativeTwoWire, NobodyAnswersWhereNoDeviceIs) {
  NativeTwoWire bus;
  std::int16_t value = 0;
  EXPECT_EQ(bus.state(0, value), TwiState::kIdle);
  bus.start_read(1000, 0x68, 0x47);
  EXPECT_EQ(bus.state(1000 + NativeTwoWire::kRefusedNs - 1, value), TwiState::kBusy);
  EXPECT_EQ(bus.state(1000 + NativeTwoWire::kRefusedNs, value), TwiState::kFailed);
  bus.start_write(500000, 0x68, 0x6B, 0);
  EXPECT_EQ(bus.state(500000 + NativeTwoWire::kRefusedNs, value), TwiState::kFailed);
}

TEST(NativeTwoWire, BringsAWordAfterTheTimeOfATransfer) {
  NativeTwoWire bus;
  bus.on_read = [](std::uint8_t address, std::uint8_t device_register) {
    return std::optional<std::int16_t>(static_cast<std::int16_t>(-256 * address + device_register));
  };
  std::int16_t value = 0;
  bus.start_read(0, 0x68, 0x47);
  EXPECT_EQ(bus.state(NativeTwoWire::kReadNs - 1, value), TwiState::kBusy);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(bus.state(NativeTwoWire::kReadNs, value), TwiState::kDone);
  EXPECT_EQ(value, -256 * 0x68 + 0x47);
}

TEST(NativeTwoWire, WritesReachTheDevice) {
  NativeTwoWire bus;
  int written = 0;
  bus.on_write = [&](std::uint8_t address, std::uint8_t device_register, std::uint8_t value) {
    written = address << 16 | device_register << 8 | value;
    return true;
  };
  std::int16_t value = 0;
  bus.start_write(0, 0x68, 0x6B, 0x01);
  EXPECT_EQ(written, 0x686B01);
  EXPECT_EQ(bus.state(NativeTwoWire::kWriteNs, value), TwiState::kDone);
}

TEST(NativeTwoWire, HeldBusNeverEndsATransferUntilItIsGivenUp) {
  NativeTwoWire bus;
  bus.on_read = [](std::uint8_t, std::uint8_t) { return std::optional<std::int16_t>(5); };
  bus.held = true;
  std::int16_t value = 0;
  bus.start_read(0, 0x68, 0x47);
  EXPECT_EQ(bus.state(1000000000000, value), TwiState::kBusy);
  bus.stop();
  EXPECT_EQ(bus.state(1000000000000, value), TwiState::kIdle);
}

}  // namespace
}  // namespace echomap::native
