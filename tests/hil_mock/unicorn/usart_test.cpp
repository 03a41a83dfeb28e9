// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/usart.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

class UsartAt115200 : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kSr = 0x00;
  static constexpr std::uint32_t kDr = 0x04;
  static constexpr std::uint32_t kBrr = 0x08;
  static constexpr std::uint32_t kCr1 = 0x0C;
  static constexpr std::uint32_t kOverrun = 1U << 3;
  static constexpr std::uint32_t kReceived = 1U << 5;
  static constexpr std::uint32_t kSendEmpty = 1U << 7;
  static constexpr std::uint64_t kByteCycles = 6250;

  UsartAt115200() {
    usart.reset();
    usart.write(kBrr, 625);
    usart.write(kCr1, 0x200C);
    usart.on_sent = [this](std::uint8_t byte) { sent.emplace_back(queue.now(), byte); };
  }

  EventQueue queue;
  Nvic nvic;
  Usart usart{queue, nvic};
  std::vector<std::pair<std::uint64_t, std::uint8_t>> sent;
};

TEST_F(UsartAt115200, SendsTenBitsAByteWithoutAGap) {
  usart.write(kDr, 'a');
  EXPECT_NE(usart.read(kSr) & kSendEmpty, 0U) << "the shift register has taken it";
  usart.write(kDr, 'b');
  EXPECT_EQ(usart.read(kSr) & kSendEmpty, 0U);
  queue.skip_to(3 * kByteCycles);
  EXPECT_THAT(sent, ElementsAre(Pair(kByteCycles, 'a'), Pair(2 * kByteCycles, 'b')));
}

TEST_F(UsartAt115200, KeepsTheFirstUnreadByteAndReportsTheOverrun) {
  const std::array<std::uint8_t, 2> bytes{'a', 'b'};
  usart.receive(bytes);
  queue.skip_to(2 * kByteCycles);
  EXPECT_EQ(usart.read(kSr) & (kReceived | kOverrun), kReceived | kOverrun);
  EXPECT_EQ(usart.read(kDr), 'a');
  EXPECT_EQ(usart.read(kSr) & (kReceived | kOverrun), 0U);
}

TEST_F(UsartAt115200, AnOverrunInterruptsLikeAByte) {
  nvic.write(0xE000E104, 1U << 5);
  usart.write(kCr1, 0x202C);
  const std::array<std::uint8_t, 2> bytes{'a', 'b'};
  usart.receive(bytes);
  queue.skip_to(2 * kByteCycles);
  usart.read(kDr);  // Without SR before it: the overrun stays.
  EXPECT_TRUE(nvic.next({}));
  usart.read(kSr);
  usart.read(kDr);
  nvic.write(0xE000E284, 1U << 5);
  EXPECT_FALSE(nvic.next({}));
}

TEST_F(UsartAt115200, IsDeafWhileSwitchedOff) {
  usart.write(kCr1, 0);
  const std::array<std::uint8_t, 1> byte{'a'};
  usart.receive(byte);
  queue.skip_to(2 * kByteCycles);
  EXPECT_EQ(usart.read(kSr) & kReceived, 0U);
}

}  // namespace
}  // namespace echomap::unicorn
