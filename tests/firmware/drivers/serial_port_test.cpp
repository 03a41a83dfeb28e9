// SPDX-License-Identifier: MIT
#include "firmware/drivers/serial_port.hpp"

#include <array>

#include <gtest/gtest.h>

namespace echomap::drivers {
namespace {

TEST(SerialPort, QueuesAFrameWholeOrNotAtAll) {
  SerialPort port;
  const std::array<std::uint8_t, 100> frame{};
  EXPECT_TRUE(port.send({frame.data(), 100}));
  EXPECT_EQ(port.send_room(), 28);
  EXPECT_FALSE(port.send({frame.data(), 29}));
  EXPECT_EQ(port.send_room(), 28);
  EXPECT_TRUE(port.send({frame.data(), 28}));
  EXPECT_EQ(port.send_room(), 0);
}

TEST(SerialPort, SendsInOrder) {
  SerialPort port;
  const std::array<std::uint8_t, 3> bytes{7, 0, 9};
  ASSERT_TRUE(port.send({bytes.data(), 3}));
  for (const std::uint8_t expected : bytes) {
    std::uint8_t byte = 255;
    ASSERT_TRUE(port.on_send_ready(byte));
    EXPECT_EQ(byte, expected);
  }
  std::uint8_t byte = 0;
  EXPECT_FALSE(port.on_send_ready(byte));
}

TEST(SerialPort, CountsEveryByteItHadNoRoomFor) {
  SerialPort port;
  for (int i = 0; i < SerialPort::kReceiveBytes + 5; ++i) {
    port.on_received(static_cast<std::uint8_t>(i));
  }
  port.on_overrun();
  EXPECT_EQ(port.overruns(), 6);
  std::uint8_t byte = 0;
  for (int i = 0; i < SerialPort::kReceiveBytes; ++i) {
    ASSERT_TRUE(port.receive(byte));
    EXPECT_EQ(byte, static_cast<std::uint8_t>(i));
  }
  EXPECT_FALSE(port.has_received());
}

}  // namespace
}  // namespace echomap::drivers
