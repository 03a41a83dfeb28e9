// SPDX-License-Identifier: MIT
#include "host/transport/line_speed.hpp"

#include <gtest/gtest.h>

#include "host/transport/serial_port.hpp"
#include "tests/host/transport/line_settings.hpp"
#include "tests/host/transport/modem_lines.hpp"
#include "tests/host/transport/pty_pair.hpp"

namespace echomap::transport {
namespace {

TEST(LineSpeed, ChangesNothingElseOfAnOpenPort) {
  PtyPair device;
  const auto port = open_serial_port(device.name(), 250000);
  const LineSettings before = line_settings(device.fd());
  const int falls = modem_lines().falls_of_dtr;
  for (const int baud : {115200, 500000, 9600, 250000, 1234567}) {
    EXPECT_TRUE(port->set_baud(baud));
    const LineSettings after = line_settings(device.fd());
    EXPECT_EQ(after.baud, static_cast<unsigned>(baud));
    EXPECT_EQ(after.min_bytes_per_read, before.min_bytes_per_read);
    EXPECT_TRUE(after.is_raw && after.has_8_bits && !after.hangs_up_on_close);
  }
  EXPECT_EQ(modem_lines().falls_of_dtr, falls);
  const auto bytes = counting_bytes(100);
  device.write(bytes);
  EXPECT_EQ(read_bytes(*port, 100), bytes);
}

TEST(LineSpeed, IsNoneOfWhatIsNoTty) {
  EXPECT_FALSE(set_line_speed(-1, 115200));
  PtyPair device;
  EXPECT_FALSE(set_line_speed(device.fd(), 0));
}

}  // namespace
}  // namespace echomap::transport
