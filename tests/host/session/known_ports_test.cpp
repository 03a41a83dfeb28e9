// SPDX-License-Identifier: MIT
#include "host/session/known_ports.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

using transport::PortInfo;
using transport::UsbId;

class KnownPortsFile : public testing::Test {
 protected:
  tests::ScratchFolder folder;
  const std::filesystem::path file = folder / "state/echomap/ports.json";
  const PortInfo uno{"/dev/ttyACM0", "Uno", "754", UsbId{0x2341, 0x0043}, "1-1:1.0"};
  const PortInfo nano{"/dev/ttyUSB0", "USB", "", UsbId{0x1a86, 0x7523}, "1-1.2:1.0"};
};

TEST_F(KnownPortsFile, KnowsADeviceUnderAnotherNameAndNoOther) {
  EXPECT_FALSE(KnownPorts(file).has(uno));
  KnownPorts(file).remember(uno);
  KnownPorts(file).remember(nano);
  const KnownPorts known(file);
  EXPECT_TRUE(known.has({"/dev/ttyACM7", "Uno", "754", UsbId{0x2341, 0x0043}, "2-1:1.0"}));
  EXPECT_FALSE(known.has({"/dev/ttyACM0", "Uno", "755", UsbId{0x2341, 0x0043}, "1-1:1.0"}));
  EXPECT_TRUE(known.has({"/dev/ttyUSB5", "USB", "", UsbId{0x1a86, 0x7523}, "1-1.2:1.0"}));
  EXPECT_FALSE(known.has({"/dev/ttyUSB0", "USB", "", UsbId{0x1a86, 0x7523}, "1-1.3:1.0"}));
}

TEST_F(KnownPortsFile, KnowsAPicoByItsSocket) {
  const PortInfo pico{"/dev/ttyACM0", "echomap Pico", "1", UsbId{0x2e8a, 0x000a}, "1-1.1:1.0"};
  PortInfo other = pico;
  other.usb_path = "1-1.2:1.0";
  PortInfo renamed = pico;
  renamed.name = "/dev/ttyACM1";
  KnownPorts(file).remember(pico);
  EXPECT_TRUE(KnownPorts(file).has(renamed));
  EXPECT_FALSE(KnownPorts(file).has(other)) << "every Pico has the same serial number";
  KnownPorts(file).remember(other);
  EXPECT_EQ(KnownPorts(file).ports().size(), 2U);
}

TEST_F(KnownPortsFile, HasADeviceOnceAndForgetsIt) {
  KnownPorts(file).remember(uno);
  PortInfo moved = uno;
  moved.name = "/dev/ttyACM1";
  KnownPorts known(file);
  known.remember(moved);
  ASSERT_EQ(KnownPorts(file).ports().size(), 1U);
  EXPECT_EQ(KnownPorts(file).ports().front().name, "/dev/ttyACM1");
  known.forget(uno);
  EXPECT_TRUE(KnownPorts(file).ports().empty());
}

TEST_F(KnownPortsFile, KeepsWhatAnotherRunHasWrittenMeanwhile) {
  KnownPorts early(file);
  KnownPorts(file).remember(uno);
  early.remember(nano);
  EXPECT_EQ(KnownPorts(file).ports().size(), 2U);
}

TEST_F(KnownPortsFile, LeavesAFileThatItCannotReadAsItIs) {
  for (const char* bad : {"",
                          "{",
                          "[]",
                          R"({"format": 2, "ports": []})",
                          R"({"format": 1, "ports": [{"name": 5}]})",
                          R"({"format": 1, "ports": [{"name": "a", "description": "",
                              "serial_number": "", "usb_id": "1a86", "usb_path": ""}]})"}) {
    std::filesystem::create_directories(file.parent_path());
    files::write_text_file(file, bad);
    KnownPorts known(file);
    EXPECT_THAT(known.trouble(), testing::HasSubstr("echomap ports --forget-all")) << bad;
    known.remember(uno);
    EXPECT_EQ(files::read_text_file(file), bad);
    known.forget_all();
    EXPECT_EQ(known.trouble(), "");
    EXPECT_EQ(files::read_text_file(file.string() + ".unreadable"), bad);
  }
}

TEST(KnownPortsPath, IsBelowTheUsersState) {
  ::setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(known_ports_file(), "/state/echomap/ports.json");
  ::setenv("XDG_STATE_HOME", "relative", 1);
  ::setenv("HOME", "/home/ada", 1);
  EXPECT_EQ(known_ports_file(), "/home/ada/.local/state/echomap/ports.json");
  ::unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace echomap::session
