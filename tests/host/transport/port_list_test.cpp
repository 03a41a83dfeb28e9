// SPDX-License-Identifier: MIT
#include "host/transport/port_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/sysfs_tree.hpp"

namespace echomap::transport {
namespace {

TEST(PortList, LeavesOutThePortsThatEveryPcHas) {
  for (const PortInfo& port : list_ports()) {
    EXPECT_THAT(port.name, testing::StartsWith("/dev/"));
    EXPECT_THAT(port.name, testing::Not(testing::StartsWith("/dev/ttyS")));
  }
}

TEST(PortList, TellsWhatIsPluggedInAndWhere) {
  const tests::ScratchFolder folder;
  tests::SysfsTree sysfs(folder.path());
  sysfs.plug("ttyUSB3", {"1-1.2", {0x1a86, 0x7523}, "USB Serial"});
  sysfs.plug("ttyACM0", {"1-4", {0x2341, 0x0043}, "Arduino Uno", "7583"});
  std::filesystem::create_directories(folder / "class/tty/ttyS0/device");
  std::filesystem::create_directories(folder / "class/tty/rfcomm0");
  const auto ports = list_ports(sysfs.root());
  ASSERT_EQ(ports.size(), 3U);
  EXPECT_EQ(ports[0].name, "/dev/rfcomm0");
  EXPECT_EQ(ports[0].usb_id, std::nullopt);
  EXPECT_EQ(ports[1].name, "/dev/ttyACM0");
  EXPECT_EQ(ports[1].serial_number, "7583");
  EXPECT_EQ(ports[1].description, "Arduino Uno");
  EXPECT_EQ(ports[2].usb_id, (UsbId{0x1a86, 0x7523}));
  EXPECT_EQ(ports[2].usb_path, "1-1.2:1.0");
  sysfs.unplug("ttyUSB3");
  EXPECT_EQ(list_ports(sysfs.root()).size(), 2U);
  EXPECT_TRUE(list_ports(folder / "nothing").empty());
}

TEST(PortList, KnowsADeviceByItsNumberWhereThatIsItsOwnAndElseByItsSocket) {
  const auto is_known_in_another_socket = [](UsbId id, const std::string& number) {
    const PortInfo here{"/dev/ttyACM0", "board", number, id, "1-1.1:1.0"};
    const PortInfo renamed{"/dev/ttyACM3", "board", number, id, "1-1.1:1.0"};
    EXPECT_TRUE(is_same_device(here, renamed)) << to_string(id) << " number '" << number << "'";
    return is_same_device(here, {"/dev/ttyACM0", "board", number, id, "1-1.2:1.0"});
  };
  constexpr UsbId kUno{0x2341, 0x0043};
  constexpr UsbId kCp2102{0x10c4, 0xea60};
  constexpr UsbId kPico{0x2e8a, 0x000a};
  EXPECT_TRUE(is_known_in_another_socket(kUno, "7583"));
  EXPECT_TRUE(is_known_in_another_socket(kUno, "1")) << "only every Pico has that";
  EXPECT_TRUE(is_known_in_another_socket(kPico, "E6614103E7")) << "with another program";
  EXPECT_FALSE(is_known_in_another_socket(kUno, ""));
  EXPECT_FALSE(is_known_in_another_socket(kCp2102, "0001"));
  EXPECT_FALSE(is_known_in_another_socket(kPico, "1")) << "two Picos were one robot";
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
