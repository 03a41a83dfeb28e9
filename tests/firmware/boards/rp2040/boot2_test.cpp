// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/boot2.hpp"

#include <array>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

namespace echomap::boards {
namespace {

/// CRC-32/MPEG-2, bit by bit through a register of its own.
std::uint32_t checksum_of(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t remainder = 0xFFFFFFFF;
  for (std::size_t at = 0; at < size * 8; ++at) {
    const std::uint32_t in = bytes[at / 8] >> (7 - at % 8) & 1U;
    const std::uint32_t out = remainder >> 31;
    remainder = (remainder << 1) ^ ((in ^ out) != 0 ? 0x04C11DB7U : 0U);
  }
  return remainder;
}

TEST(Boot2, TheChecksumOfTheTestIsTheCataloguesOne) {
  EXPECT_EQ(checksum_of(reinterpret_cast<const std::uint8_t*>("123456789"), 9), 0x0376E6E7U);
}

TEST(Boot2, TheLastWordIsTheChecksumOfThe252BytesBefore) {
  const Boot2 boot2;
  std::array<std::uint8_t, 256> bytes{};
  std::memcpy(bytes.data(), &boot2, bytes.size());
  EXPECT_EQ(boot2.checksum, checksum_of(bytes.data(), 252));
}

}  // namespace
}  // namespace echomap::boards
