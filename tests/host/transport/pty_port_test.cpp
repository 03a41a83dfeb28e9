// SPDX-License-Identifier: MIT
#include "host/transport/pty_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

using testing::HasSubstr;

TEST(PtyPort, CarriesEveryByteBothWaysUnchanged) {
  PtyPair device;
  const auto port = open_pty_port(device.name());
  const auto bytes = counting_bytes(1024);
  port->write(bytes);
  EXPECT_EQ(device.read(1024), bytes);
  device.write(bytes);
  EXPECT_EQ(read_bytes(*port, 1024), bytes);
  EXPECT_EQ(port->name(), device.name());
}

TEST(PtyPort, DropsWhatWasSentBeforeItWasOpened) {
  PtyPair device;
  device.write(counting_bytes(500));
  const auto port = open_pty_port(device.name());
  const std::vector<std::uint8_t> fresh = {0xAA, 0xBB};
  device.write(fresh);
  EXPECT_EQ(read_bytes(*port, 2), fresh);
}

TEST(PtyPort, StaysOpenWhileNothingComes) {
  PtyPair device;
  const auto port = open_pty_port(device.name());
  std::array<std::uint8_t, 8> into{};
  EXPECT_EQ(port->read_some(into, std::chrono::microseconds(0)), 0U);
  EXPECT_EQ(port->read_some(into, std::chrono::milliseconds(5)), 0U);
  EXPECT_EQ(port->status(), StreamStatus::kOpen);
  EXPECT_EQ(port->close_reason(), "");
}

TEST(PtyPort, CanBeOpenedAgainAfterItsHostHasGone) {
  PtyPair device;
  for (int i = 0; i < 20; ++i) {
    const auto port = open_pty_port(device.name());
    device.write(counting_bytes(100));
    ASSERT_EQ(read_bytes(*port, 100), counting_bytes(100));
  }
}

TEST(PtyPort, SaysThatTheDeviceIsGoneAndDropsWhatIsWritten) {
  PtyPair device;
  const auto port = open_pty_port(device.name());
  device.unplug();
  EXPECT_TRUE(read_bytes(*port, 1).empty());
  EXPECT_EQ(port->status(), StreamStatus::kClosed);
  EXPECT_EQ(port->close_reason(), "the other end closed it");
  port->write(counting_bytes(10));
  EXPECT_EQ(port->close_reason(), "the other end closed it");
}

TEST(PtyPort, NoticesADeadDeviceByWritingAlone) {
  PtyPair device;
  const auto port = open_pty_port(device.name());
  device.unplug();
  port->write(counting_bytes(10));
  EXPECT_EQ(port->status(), StreamStatus::kClosed);
}

TEST(PtyPort, GivesUpOnADeviceThatTakesNothing) {
  PtyPair device;
  const auto port = open_pty_port(device.name());
  port->write(counting_bytes(1'000'000));
  EXPECT_EQ(port->status(), StreamStatus::kClosed);
  EXPECT_THAT(port->close_reason(), HasSubstr("took no bytes"));
}

TEST(PtyPort, RefusesWhatIsNoPtyAndSaysWhy) {
  try {
    open_pty_port("/dev/pts/nobody");
    FAIL() << "it opened";
  } catch (const TransportError& error) {
    EXPECT_THAT(error.failure(), HasSubstr("/dev/pts/nobody"));
    EXPECT_EQ(error.why(), "No such file or directory");
    EXPECT_THAT(error.what(), HasSubstr("next: "));
  }
  EXPECT_THROW(open_pty_port("/dev/null"), TransportError);
}

}  // namespace
}  // namespace echomap::transport
