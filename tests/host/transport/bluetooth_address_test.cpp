// SPDX-License-Identifier: MIT
#include "host/transport/bluetooth_address.hpp"

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(BluetoothAddress, HasSixBytesAndTheFirstChannel) {
  const auto address = parse_bluetooth_address("bt://00:14:03:05:59:fE");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->bytes, (std::array<std::uint8_t, 6>{0x00, 0x14, 0x03, 0x05, 0x59, 0xFE}));
  EXPECT_EQ(address->channel, 1);
}

TEST(BluetoothAddress, MayNameAChannel) {
  EXPECT_EQ(parse_bluetooth_address("bt://00:14:03:05:59:02/30")->channel, 30);
}

TEST(BluetoothAddress, IsNoneWhereAPartIsWrong) {
  for (const char* wrong : {"bt://",
                            "bt://00:14:03:05:59",
                            "bt://00:14:03:05:59:0",
                            "bt://00:14:03:05:59:0g",
                            "bt://00-14-03-05-59-02",
                            "bt://00:14:03:05:59:02:03",
                            "bt://00:14:03:05:59:02/",
                            "bt://00:14:03:05:59:02/0",
                            "bt://00:14:03:05:59:02/31",
                            "bt://00:14:03:05:59:02/1x",
                            "00:14:03:05:59:02"}) {
    EXPECT_FALSE(parse_bluetooth_address(wrong)) << wrong;
  }
}

TEST(BluetoothAddress, IsToldByItsScheme) {
  EXPECT_TRUE(is_bluetooth_address("bt://nonsense"));
  EXPECT_FALSE(is_bluetooth_address("/dev/rfcomm0"));
}

}  // namespace
}  // namespace echomap::transport
