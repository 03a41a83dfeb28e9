// SPDX-License-Identifier: MIT
#include "host/transport/usb_id.hpp"

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(UsbId, IsWrittenAsLsusbWritesIt) {
  EXPECT_EQ(to_string(UsbId{0x2341, 0x0043}), "2341:0043");
  EXPECT_EQ(to_string(UsbId{0xffff, 0xea60}), "ffff:ea60");
}

}  // namespace
}  // namespace echomap::transport
