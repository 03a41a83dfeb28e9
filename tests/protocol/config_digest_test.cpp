// SPDX-License-Identifier: MIT
#include "protocol/config_digest.hpp"

#include <gtest/gtest.h>

namespace echomap::protocol {
namespace {

TEST(ConfigDigest, ChangesWithEveryBitButNotWithCommandIds) {
  const Configuration base{};
  const ConfigurationBytes bytes = configuration_bytes(base);
  for (int bit = 0; bit < 8 * ConfigurationBytes::kSize; ++bit) {
    ConfigurationBytes changed = bytes;
    changed.bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    Configuration other{};
    if (read_configuration(changed, other)) {
      EXPECT_NE(config_digest(other), config_digest(base)) << "bit " << bit;
    }
  }
  Configuration commanded = base;
  commanded.drive.command_id = 7;
  commanded.safety.command_id = 8;
  EXPECT_EQ(config_digest(commanded), config_digest(base));
}

TEST(ConfigDigest, IsFnv1aOverIdsAndPayloads) {
  // FNV-1a over 0x12 and 12 zeros, 0x13 and 3, 0x16 and 17, 0x17 and 16, 0x18 and 3, 0x19 and 7,
  // 0x1A and 3, 0x1B and 2.
  std::uint32_t expected = 2166136261U;
  const auto add = [&](unsigned byte) { expected = (expected ^ byte) * 16777619U; };
  const int zeros[] = {12, 3, 17, 16, 3, 7, 3, 2};
  const unsigned ids[] = {0x12, 0x13, 0x16, 0x17, 0x18, 0x19, 0x1A, 0x1B};
  for (int i = 0; i < 8; ++i) {
    add(ids[i]);
    for (int zero = 0; zero < zeros[i]; ++zero) {
      add(0);
    }
  }
  EXPECT_EQ(config_digest(Configuration{}), expected);
}

}  // namespace
}  // namespace echomap::protocol
