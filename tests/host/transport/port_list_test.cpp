// SPDX-License-Identifier: MIT
#include "host/transport/port_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(PortList, LeavesOutThePortsThatEveryPcHas) {
  for (const PortInfo& port : list_ports()) {
    EXPECT_THAT(port.name, testing::StartsWith("/dev/"));
    EXPECT_THAT(port.name, testing::Not(testing::StartsWith("/dev/ttyS")));
  }
}

TEST(PortList, IsDescribedInOneLine) {
  EXPECT_EQ(describe_ports({}), "no USB or Bluetooth serial port is here");
  EXPECT_EQ(describe_ports({{"/dev/ttyACM0", "Arduino Uno", "75833"}, {"/dev/ttyUSB1", "", ""}}),
            "ports here: /dev/ttyACM0 (Arduino Uno) /dev/ttyUSB1");
}

}  // namespace
}  // namespace echomap::transport
