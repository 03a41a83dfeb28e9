// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/usb_descriptors.hpp"

#include <gtest/gtest.h>

namespace echomap::boards::usb {
namespace {

TEST(UsbDescriptors, EachSaysItsLengthAndItsTypeFirst) {
  for (const std::uint8_t type : {std::uint8_t{1}, std::uint8_t{3}}) {
    for (std::uint8_t index = 0; index < (type == 3 ? 4 : 1); ++index) {
      const Bytes bytes = descriptor(type, index);
      ASSERT_GE(bytes.size, 4);
      EXPECT_EQ(bytes.data[0], bytes.size);
      EXPECT_EQ(bytes.data[1], type);
    }
  }
}

TEST(UsbDescriptors, OtherTypesAndIndicesAreEmpty) {
  EXPECT_EQ(descriptor(1, 1).size, 0);
  EXPECT_EQ(descriptor(3, 4).size, 0);
  EXPECT_EQ(descriptor(6, 0).size, 0) << "device qualifier: of high speed only";
}

}  // namespace
}  // namespace echomap::boards::usb
