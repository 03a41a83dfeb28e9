// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/boot2.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include <gtest/gtest.h>

#include "tests/firmware/boards/rp2040/boot2_checksum.hpp"

namespace echomap::boards {
namespace {

TEST(Boot2, TheChecksumOfTheTestIsTheCataloguesOne) {
  constexpr std::array<std::uint8_t, 9> kDigits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(checksum_of(kDigits), 0x0376E6E7U);
}

TEST(Boot2, TheLastWordIsTheChecksumOfThe252BytesBefore) {
  const Boot2 boot2;
  std::array<std::uint8_t, 256> bytes{};
  std::memcpy(bytes.data(), &boot2, bytes.size());
  EXPECT_EQ(boot2.checksum, checksum_of(std::span(bytes).first<kBoot2CheckedBytes>()));
}

}  // namespace
}  // namespace echomap::boards
