// SPDX-License-Identifier: MIT
#include "host/transport/low_latency.hpp"

#include <gtest/gtest.h>
#include <linux/serial.h>

#include "host/transport/serial_port.hpp"
#include "tests/host/transport/modem_lines.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

/// On a pty for which pty_as_serial_port.cpp answers as a driver does.
class LowLatency : public testing::Test {
 protected:
  ~LowLatency() override { modem_lines() = {}; }

  const PtyPair device;
};

TEST_F(LowLatency, IsLeftAloneWhereTheDriverHasNoneOrHasItAlready) {
  EXPECT_FALSE(lower_latency(device.fd()));
  modem_lines().driver_flags = ASYNC_LOW_LATENCY | ASYNC_SPD_HI;
  EXPECT_FALSE(lower_latency(device.fd()));
  EXPECT_EQ(modem_lines().driver_flags, ASYNC_LOW_LATENCY | ASYNC_SPD_HI);
}

TEST_F(LowLatency, LastsAsLongAsThePortIsOpen) {
  modem_lines().driver_flags = ASYNC_SPD_HI;
  {
    const auto port = open_serial_port(device.name(), 115200);
    EXPECT_EQ(modem_lines().driver_flags, ASYNC_LOW_LATENCY | ASYNC_SPD_HI);
  }
  EXPECT_EQ(modem_lines().driver_flags, ASYNC_SPD_HI);
}

}  // namespace
}  // namespace echomap::transport
