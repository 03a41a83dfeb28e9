// SPDX-License-Identifier: MIT
#include "host/robot_link/credit_window.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;
using tests::at_ms;

constexpr AnswerKey kPong7{5, 7};
constexpr AnswerKey kPong8{5, 8};

TEST(CreditWindow, HoldsNothingBackBeforeTheGrant) {
  CreditWindow window;
  window.add(1000, std::nullopt, at_ms(0));
  EXPECT_TRUE(window.has_room(1000, 0));
  window.grant(128);
  EXPECT_FALSE(window.has_room(1, 0));
}

TEST(CreditWindow, KeepsTheSpareFree) {
  CreditWindow window;
  window.grant(100);
  window.add(60, std::nullopt, at_ms(0));
  EXPECT_TRUE(window.has_room(40, 0));
  EXPECT_FALSE(window.has_room(41, 0));
  EXPECT_TRUE(window.has_room(15, 25));
  EXPECT_FALSE(window.has_room(16, 25));
}

TEST(CreditWindow, IsConfirmedUpToTheFrameThatWasAnswered) {
  CreditWindow window;
  window.grant(100);
  window.add(10, std::nullopt, at_ms(0));
  window.add(20, kPong7, at_ms(0));
  window.add(30, kPong8, at_ms(0));
  window.confirm({5, 9});
  EXPECT_EQ(window.unconfirmed_bytes(), 60U);
  window.confirm(kPong7);
  EXPECT_EQ(window.unconfirmed_bytes(), 30U);
  window.confirm(kPong7);
  EXPECT_EQ(window.unconfirmed_bytes(), 30U);
  window.confirm(kPong8);
  EXPECT_EQ(window.unconfirmed_bytes(), 0U);
}

TEST(CreditWindow, TakesAnAnswerToAResentFrameForThatOfTheFirst) {
  CreditWindow window;
  window.add(10, kPong7, at_ms(0));
  window.add(5, std::nullopt, at_ms(0));
  window.add(10, kPong7, at_ms(25));
  window.confirm(kPong7);
  EXPECT_EQ(window.unconfirmed_bytes(), 15U);
}

TEST(CreditWindow, ReleasesWhatNoAnswerConfirmedInTime) {
  CreditWindow window({.release_after = milliseconds(300)});
  window.grant(100);
  window.add(70, kPong7, at_ms(0));
  window.add(30, kPong8, at_ms(100));
  window.release_overdue(at_ms(299));
  EXPECT_FALSE(window.has_room(1, 0));
  window.release_overdue(at_ms(300));
  EXPECT_EQ(window.unconfirmed_bytes(), 30U);
  EXPECT_EQ(window.released_bytes(), 70U);
}

TEST(CreditWindow, LetsALoneFrameThroughAnyGrant) {
  CreditWindow window;
  window.grant(4);
  EXPECT_TRUE(window.has_room(19, 0));
  window.add(19, kPong7, at_ms(0));
  EXPECT_FALSE(window.has_room(1, 0));
}

TEST(CreditWindow, AsksForAnAnswerWhenAQuarterHasNone) {
  CreditWindow window;
  window.grant(100);
  window.add(24, std::nullopt, at_ms(0));
  EXPECT_FALSE(window.wants_answer());
  window.add(8, std::nullopt, at_ms(0));
  EXPECT_TRUE(window.wants_answer());
  window.add(10, kPong7, at_ms(0));
  EXPECT_FALSE(window.wants_answer());
}

TEST(CreditWindow, RefusesToReleaseAtOnce) {
  EXPECT_THROW(CreditWindow({.release_after = milliseconds(0)}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
