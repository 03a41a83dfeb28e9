// SPDX-License-Identifier: MIT
#include "firmware/hal/events.hpp"

#include <gtest/gtest.h>

#include "firmware/app/robot.hpp"
#include "firmware/boards/native/native_board.hpp"

namespace echomap::hal {
namespace {

class EventsTest : public testing::Test {
 protected:
  EventsTest() { native::NativeBoard::instance().power_on(); }
  app::Devices& devices = app::devices;
};

TEST_F(EventsTest, TickReachesTheScheduler) {
  EXPECT_FALSE(devices.scheduler.has_tick());
  on_tick();
  EXPECT_TRUE(devices.scheduler.has_tick());
}

TEST_F(EventsTest, EchoEdgesReachTheSonar) {
  devices.sonar.ping(0);
  on_echo_edge(true, 1000);
  on_echo_edge(false, 3000);
  std::uint16_t flight_us = 0;
  EXPECT_TRUE(devices.sonar.poll(2000, 24000, flight_us));
  EXPECT_EQ(flight_us, 1000);
}

TEST_F(EventsTest, BytesReachThePortAndLeaveIt) {
  on_byte_received(42);
  on_receive_overrun();
  std::uint8_t byte = 0;
  EXPECT_TRUE(devices.port.receive(byte));
  EXPECT_EQ(byte, 42);
  EXPECT_EQ(devices.port.overruns(), 1);
  const std::uint8_t before = devices.port.send_room();
  EXPECT_TRUE(next_byte_to_send(byte));
  EXPECT_EQ(devices.port.send_room(), before + 1);
}

}  // namespace
}  // namespace echomap::hal
