// SPDX-License-Identifier: MIT
#include "host/robot_link/retransmission_timer.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;

constexpr RetransmissionParams kParams{
    .initial = milliseconds(200), .floor = milliseconds(25), .ceiling = milliseconds(400)};

TEST(RetransmissionTimer, StartsWithTheInitialTimeout) {
  const RetransmissionTimer timer(kParams);
  EXPECT_EQ(timer.timeout(), milliseconds(200));
  EXPECT_FALSE(timer.smoothed_round_trip());
}

TEST(RetransmissionTimer, FollowsRfc6298ByHand) {
  RetransmissionTimer timer(kParams);
  timer.sample(milliseconds(40));  // SRTT = R, RTTVAR = R / 2
  EXPECT_EQ(*timer.smoothed_round_trip(), milliseconds(40));
  EXPECT_EQ(timer.timeout(), milliseconds(40 + 4 * 20));
  timer.sample(milliseconds(80));  // RTTVAR = 3/4 20 + 1/4 |40 - 80|, SRTT = 7/8 40 + 1/8 80
  EXPECT_EQ(*timer.smoothed_round_trip(), milliseconds(45));
  EXPECT_EQ(timer.timeout(), milliseconds(45 + 4 * 25));
}

TEST(RetransmissionTimer, SettlesOnTheFloorForAFastSteadyLine) {
  RetransmissionTimer timer(kParams);
  for (int i = 0; i < 100; ++i) {
    timer.sample(milliseconds(3));
  }
  EXPECT_EQ(timer.timeout(), milliseconds(25));
}

TEST(RetransmissionTimer, NeverResendsWithin200MsOverARadio) {
  RetransmissionTimer timer(radio_retransmission());
  for (int i = 0; i < 100; ++i) {
    timer.sample(milliseconds(20));
  }
  EXPECT_EQ(timer.timeout(), milliseconds(200));
}

TEST(RetransmissionTimer, DoublesUpToTheCeilingUntilTheNextSample) {
  RetransmissionTimer timer(kParams);
  timer.sample(milliseconds(3));
  for (const int expected_ms : {50, 100, 200, 400, 400}) {
    timer.back_off();
    EXPECT_EQ(timer.timeout(), milliseconds(expected_ms));
  }
  timer.sample(milliseconds(3));
  EXPECT_EQ(timer.timeout(), milliseconds(25));
}

TEST(RetransmissionTimer, StaysWithinItsBoundsWhateverItSees) {
  std::mt19937 random(5);
  RetransmissionTimer timer(kParams);
  for (int i = 0; i < 10'000; ++i) {
    timer.sample(milliseconds(random() % 2000));
    if (random() % 3 == 0) {
      timer.back_off();
    }
    ASSERT_GE(timer.timeout(), kParams.floor);
    ASSERT_LE(timer.timeout(), kParams.ceiling);
  }
}

TEST(RetransmissionTimer, RefusesBoundsOutOfOrder) {
  EXPECT_THROW(RetransmissionTimer({.floor = milliseconds(0)}), std::invalid_argument);
  EXPECT_THROW(RetransmissionTimer({.initial = milliseconds(10)}), std::invalid_argument);
  EXPECT_THROW(RetransmissionTimer({.ceiling = milliseconds(100)}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
