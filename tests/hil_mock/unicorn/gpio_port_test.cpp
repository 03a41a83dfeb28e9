// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/gpio_port.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

constexpr std::uint32_t kCrl = 0x00;
constexpr std::uint32_t kIdr = 0x08;
constexpr std::uint32_t kOdr = 0x0C;
constexpr std::uint32_t kBsrr = 0x10;
constexpr std::uint32_t kBrr = 0x14;
/// Modes of a pin.
constexpr std::uint32_t kAnalog = 0x0;
constexpr std::uint32_t kOutput = 0x2;
constexpr std::uint32_t kFloating = 0x4;
constexpr std::uint32_t kPulled = 0x8;
constexpr std::uint32_t kAlternate = 0xA;

/// All of pins 0 to 7 are in the same mode.
class Port : public ::testing::Test {
 protected:
  Port() { port.reset(); }

  void set_mode(std::uint32_t mode) { port.write(kCrl, mode * 0x11111111); }

  GpioPort port;
};

TEST_F(Port, AnOutputHasTheLevelThatTheProgramGivesIt) {
  set_mode(kOutput);
  port.write(kBsrr, 0b1010);
  EXPECT_EQ(port.read(kIdr), 0b1010U);
  port.write(kBsrr, 0b0010U << 16 | 0b0001);
  EXPECT_EQ(port.read(kOdr), 0b1001U);
  port.write(kBrr, 0b1000);
  EXPECT_TRUE(port.is_driven_high(0));
  EXPECT_FALSE(port.is_driven_high(3));
}

TEST_F(Port, AnInputFollowsItsPullUntilSomebodyDrivesIt) {
  set_mode(kPulled);
  port.write(kOdr, 1);
  EXPECT_EQ(port.read(kIdr), 1U);
  EXPECT_FALSE(port.is_driven_high(0)) << "that is the pull-up only";
  port.drive(0, false);
  port.drive(1, true);
  EXPECT_EQ(port.read(kIdr), 2U);
  set_mode(kFloating);
  EXPECT_EQ(port.read(kIdr), 2U);
  set_mode(kAnalog);
  EXPECT_EQ(port.read(kIdr), 0U);
}

TEST_F(Port, APinOfATimerIsNotTheProgramsToDrive) {
  set_mode(kAlternate);
  port.write(kOdr, 1);
  EXPECT_TRUE(port.is_alternate(0));
  EXPECT_FALSE(port.is_driven_high(0));
}

TEST_F(Port, APinThatIsTakenAwayIsNobodysHere) {
  port.write(kOdr, 1U << 4);
  port.take_away(1U << 4);
  set_mode(kOutput);
  EXPECT_FALSE(port.is_driven_high(4));
  EXPECT_EQ(port.read(kIdr), 0U);
  set_mode(kAlternate);
  EXPECT_FALSE(port.is_alternate(4));
  EXPECT_TRUE(port.is_alternate(3));
  set_mode(kOutput);
  port.take_away(0);
  EXPECT_TRUE(port.is_driven_high(4));
}

TEST_F(Port, ASignalIsDrivenPulledUpOrFloating) {
  port.reset();
  EXPECT_EQ(port.signal(4), world::floating());
  port.take_away(1U << 4);
  EXPECT_EQ(port.signal(4), world::pulled_up()) << "JTAG's reset";
  port.take_away(0);
  set_mode(kPulled);
  port.write(kOdr, 1U << 4);
  EXPECT_EQ(port.signal(4), world::pulled_up());
  EXPECT_EQ(port.signal(3), world::floating()) << "pulled down";
  set_mode(kOutput);
  EXPECT_EQ(port.signal(4), world::level(true));
  EXPECT_EQ(port.signal(3), world::level(false));
}

TEST_F(Port, TellsEachChangeOnce) {
  std::vector<std::pair<int, bool>> changes;
  port.on_change = [&](std::uint8_t pin, bool high) { changes.emplace_back(pin, high); };
  port.drive(2, true);
  port.drive(2, true);
  port.write(kOdr, 8);
  set_mode(kOutput);
  EXPECT_THAT(changes, ElementsAre(Pair(2, true), Pair(2, false), Pair(3, true)));
}

TEST_F(Port, AResetMakesEveryPinAFloatingInputAsItIsDriven) {
  set_mode(kOutput);
  port.write(kOdr, 0xFF);
  port.drive(5, true);
  port.reset();
  EXPECT_EQ(port.read(kIdr), 1U << 5);
  EXPECT_EQ(port.read(kOdr), 0U);
  EXPECT_EQ(port.read(kCrl), 0x44444444U);
}

}  // namespace
}  // namespace echomap::unicorn
