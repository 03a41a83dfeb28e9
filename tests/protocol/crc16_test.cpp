// SPDX-License-Identifier: MIT
#include "protocol/crc16.hpp"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

namespace echomap::protocol {
namespace {

const auto* const check_text = reinterpret_cast<const std::uint8_t*>("123456789");

/// Polynomial 0x1021 reflected, one bit at a time, as the catalogues define it.
std::uint16_t bitwise_update(std::uint16_t crc, std::uint8_t byte) {
  unsigned state = crc ^ static_cast<unsigned>(byte);
  for (int bit = 0; bit < 8; ++bit) {
    state = (state & 1U) != 0 ? (state >> 1) ^ 0x8408U : state >> 1;
  }
  return static_cast<std::uint16_t>(state);
}

// The check values are those of the catalogue of parametrised CRC algorithms
// (reveng.sourceforge.io).
TEST(Crc16, GivesTheCheckValueOfX25) { EXPECT_EQ(crc16(check_text, 9, 0xFFFF), 0x906E); }

TEST(Crc16, GivesTheCheckValueOfKermitWithoutTheComplement) {
  EXPECT_EQ(static_cast<std::uint16_t>(~crc16(check_text, 9, 0x0000)), 0x2189);
}

TEST(Crc16, GivesTheCheckValueOfMcrf4xxWithoutTheComplement) {
  EXPECT_EQ(static_cast<std::uint16_t>(~crc16(check_text, 9, 0xFFFF)), 0x6F91);
}

TEST(Crc16, OneStepEqualsEightBitwiseStepsForEveryStateAndByte) {
  for (unsigned crc = 0; crc <= 0xFFFF; crc += 7) {
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
      const auto state = static_cast<std::uint16_t>(crc);
      const auto next = static_cast<std::uint8_t>(byte);
      ASSERT_EQ(crc16_update(state, next), bitwise_update(state, next)) << crc << ' ' << byte;
    }
  }
}

TEST(Crc16, IsTheComplementedSeedOverNothing) {
  EXPECT_EQ(crc16(check_text, 0, 0x1234), static_cast<std::uint16_t>(~0x1234));
}

TEST(Crc16, DiffersForEverySeed) {
  EXPECT_NE(crc16(check_text, 9, 0x1234), crc16(check_text, 9, 0x1235));
}

}  // namespace
}  // namespace echomap::protocol
