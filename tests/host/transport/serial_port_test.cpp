// SPDX-License-Identifier: MIT
#include "host/transport/serial_port.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/line_settings.hpp"
#include "tests/host/transport/modem_lines.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// On a pty that pty_as_serial_port.cpp passes off as a device.
TEST(SerialPort, CarriesEveryByteBothWaysUnchanged) {
  PtyPair device;
  const auto port = open_serial_port(device.name(), 115200);
  const auto bytes = counting_bytes(1024);
  port->write(bytes);
  EXPECT_EQ(device.read(1024), bytes);
  device.write(bytes);
  EXPECT_EQ(read_bytes(*port, 1024), bytes);
}

TEST(SerialPort, DoesNotTakeAnIdleLineForTheEndOfTheStream) {
  PtyPair device;
  const auto port = open_serial_port(device.name(), 115200);
  std::array<std::uint8_t, 8> into{};
  EXPECT_EQ(port->read_some(into, std::chrono::milliseconds(5)), 0U);
  EXPECT_EQ(port->status(), StreamStatus::kOpen);
  EXPECT_EQ(line_settings(device.fd()).min_bytes_per_read, 1U);
}

TEST(SerialPort, TakesAnyBaudRate) {
  for (const int baud : {9600, 57600, 115200, 100000, 250000, 500000, 1000000}) {
    PtyPair device;
    const auto port = open_serial_port(device.name(), baud);
    const LineSettings settings = line_settings(device.fd());
    EXPECT_EQ(settings.baud, static_cast<unsigned>(baud));
    EXPECT_TRUE(settings.is_raw);
    EXPECT_TRUE(settings.has_8_bits);
  }
}

TEST(SerialPort, DoesNotHangUpWhenItCloses) {
  PtyPair device;
  open_serial_port(device.name(), 115200);
  EXPECT_FALSE(line_settings(device.fd()).hangs_up_on_close);
}

TEST(SerialPort, LeavesDtrUpWhereARobotRuns) {
  PtyPair device;
  modem_lines() = {.up = TIOCM_DTR | TIOCM_RTS};
  for (int i = 0; i < 3; ++i) {
    open_serial_port(device.name(), 115200);
    EXPECT_EQ(modem_lines().up, TIOCM_DTR | TIOCM_RTS);
  }
  EXPECT_EQ(modem_lines().falls_of_dtr, 0);
}

TEST(SerialPort, DoesNotHangUpWhereOpeningFailsHalfway) {
  for (int requests = 0; requests < 15; ++requests) {
    PtyPair device;
    modem_lines() = {.up = TIOCM_DTR, .requests_until_failure = requests};
    EXPECT_THROW(open_serial_port(device.name(), 115200), TransportError) << requests;
    EXPECT_FALSE(line_settings(device.fd()).hangs_up_on_close) << requests;
    EXPECT_EQ(modem_lines().falls_of_dtr, 0);
  }
  modem_lines() = {};
}

TEST(SerialPort, FollowsLinksAndKeepsTheNameThatItWasGiven) {
  PtyPair device;
  const tests::ScratchFolder folder;
  const std::string link = (folder / "usb-robot-if00").string();
  std::filesystem::create_symlink(device.name(), link);
  const auto port = open_serial_port(link, 115200);
  port->write(counting_bytes(16));
  EXPECT_EQ(device.read(16), counting_bytes(16));
  EXPECT_EQ(port->name(), link);
}

TEST(SerialPort, SaysThatTheDeviceIsGone) {
  PtyPair device;
  const auto port = open_serial_port(device.name(), 115200);
  device.unplug();
  EXPECT_TRUE(read_bytes(*port, 1).empty());
  EXPECT_EQ(port->status(), StreamStatus::kClosed);
  EXPECT_NE(port->close_reason(), "");
}

TEST(SerialPort, NamesThePortsThereAreWhereTheOneIsMissing) {
  try {
    open_serial_port("/dev/ttyNOBODY7", 115200);
    FAIL() << "it opened";
  } catch (const TransportError& error) {
    EXPECT_THAT(error.failure(), HasSubstr("/dev/ttyNOBODY7"));
    EXPECT_THAT(error.why(), HasSubstr("No such file or directory; "));
    EXPECT_THAT(error.why(), AnyOf(HasSubstr("ports here: "), HasSubstr("no USB or Bluetooth")));
    EXPECT_THAT(error.next_step(), HasSubstr("echomap "));
  }
}

TEST(SerialPort, RefusesWhatIsNoSerialDevice) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(open_serial_port("/dev/null", 115200), TransportError);
  EXPECT_THROW(open_serial_port((folder / "").string(), 115200), TransportError);
}

TEST(SerialPort, RefusesABaudRateThatIsNone) {
  PtyPair device;
  EXPECT_THROW(open_serial_port(device.name(), -5), TransportError);
}

}  // namespace
}  // namespace echomap::transport
