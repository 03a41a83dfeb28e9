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

TEST(PortList, FindsPortsByAPartOfTheirId) {
  EXPECT_EQ(port_id_text("id:7583"), "7583");
  EXPECT_EQ(port_id_text("/dev/ttyACM0"), std::nullopt);
  const std::vector<PortInfo> ports{{"/dev/ttyACM0", "Arduino Uno", "7583"},
                                    {"/dev/ttyUSB1", "Arduino Nano", "12"}};
  ASSERT_EQ(ports_with_id(ports, "7583").size(), 1U);
  EXPECT_EQ(ports_with_id(ports, "7583").front().name, "/dev/ttyACM0");
  EXPECT_EQ(ports_with_id(ports, "Arduino").size(), 2U);
  EXPECT_TRUE(ports_with_id(ports, "modem").empty());
}

}  // namespace
}  // namespace echomap::transport
