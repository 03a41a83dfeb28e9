// SPDX-License-Identifier: MIT
#include "host/robot_link/setpoint_slot.hpp"

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using tests::at_ms;

TEST(SetpointSlot, GivesTheLatestOnce) {
  SetpointSlot slot;
  slot.put({1, 1, 200}, at_ms(0));
  slot.put({2, 2, 200}, at_ms(1));
  ASSERT_TRUE(slot.is_waiting());
  const auto setpoint = slot.take();
  ASSERT_TRUE(setpoint);
  EXPECT_EQ(setpoint->left_ticks_per_s, 2);
  EXPECT_FALSE(slot.is_waiting());
  EXPECT_FALSE(slot.take());
  EXPECT_EQ(slot.dropped(), 1U);
}

TEST(SetpointSlot, KeepsOneForItsOwnTimeToLive) {
  SetpointSlot slot;
  slot.put({1, 1, 80}, at_ms(1000));
  slot.drop_expired(at_ms(1080));
  EXPECT_TRUE(slot.is_waiting());
  slot.drop_expired(at_ms(1081));
  EXPECT_FALSE(slot.is_waiting());
  EXPECT_EQ(slot.dropped(), 1U);
}

TEST(SetpointSlot, ReadsATimeToLiveOfZeroAsTheDefaultOf200Ms) {
  SetpointSlot slot;
  slot.put({1, 1, 0}, at_ms(0));
  slot.drop_expired(at_ms(200));
  EXPECT_TRUE(slot.is_waiting());
  slot.drop_expired(at_ms(201));
  EXPECT_FALSE(slot.is_waiting());
}

}  // namespace
}  // namespace echomap::robot_link
