// SPDX-License-Identifier: MIT
#include "host/robot_link/ping_sender.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using tests::at_ms;

constexpr double kSharpUs = 90.0;
constexpr double kBlurredUs = 110.0;

int pings_between(PingSender& sender,
                  int from_ms,
                  int to_ms,
                  std::optional<double> uncertainty_us) {
  int count = 0;
  for (int now_ms = from_ms; now_ms < to_ms; ++now_ms) {
    if (sender.is_due(at_ms(now_ms))) {
      sender.take(at_ms(now_ms), uncertainty_us);
      ++count;
    }
  }
  return count;
}

TEST(PingSender, AsksOftenAtFirstAndThenOnceASecond) {
  PingSender sender({});
  sender.restart(at_ms(0));
  EXPECT_NEAR(pings_between(sender, 0, 5000, kSharpUs), 390, 15);
  EXPECT_NEAR(pings_between(sender, 5000, 15'000, kSharpUs), 10, 1);
  sender.restart(at_ms(15'000));
  EXPECT_NEAR(pings_between(sender, 15'000, 16'000, kSharpUs), 77, 3);
}

TEST(PingSender, GoesOnAskingWhileTheClockIsBlurred) {
  PingSender sender({});
  sender.restart(at_ms(0));
  pings_between(sender, 0, 5000, {});
  EXPECT_NEAR(pings_between(sender, 5000, 15'000, kBlurredUs), 190, 5);
  EXPECT_NEAR(pings_between(sender, 15'000, 25'000, {}), 190, 5);
  EXPECT_NEAR(pings_between(sender, 25'000, 35'000, kSharpUs), 10, 1);
}

TEST(PingSender, MeetsEveryPhaseOfALatencyTimer) {
  PingSender sender({});
  sender.restart(at_ms(0));
  std::array<int, 16> pings_at_phase{};
  for (int now_ms = 0; now_ms < 60'000; ++now_ms) {
    if (sender.is_due(at_ms(now_ms))) {
      sender.take(at_ms(now_ms), kBlurredUs);
      ++pings_at_phase.at(static_cast<std::size_t>(now_ms % 16));
    }
  }
  const auto [fewest, most] = std::ranges::minmax(pings_at_phase);
  EXPECT_GT(fewest, most / 2);
}

TEST(PingSender, FillsAMillisecondOfEachPhaseWithDelimiters) {
  PingSender sender({});
  sender.restart(at_ms(0));
  std::array<int, 13> pings_with_lead{};
  int now_ms = 0;
  for (int i = 0; i < 2600; ++i) {
    ++pings_with_lead.at(sender.lead_bytes());
    sender.take(at_ms(now_ms), kBlurredUs);
    now_ms += 50;
  }
  EXPECT_NEAR(pings_with_lead[0], 1300 + 100, 10) << "every other goes at once";
  for (std::size_t lead = 1; lead < pings_with_lead.size(); ++lead) {
    EXPECT_NEAR(pings_with_lead.at(lead), 100, 10) << lead;
  }
}

TEST(PingSender, SendsNoDelimitersWhereTheyTellNothing) {
  PingSender sender({.max_lead_bytes = 0});
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(sender.lead_bytes(), 0U);
    sender.take(at_ms(i), {});
  }
}

TEST(PingSender, KnowsTheLastPingsEachOnce) {
  PingSender sender({});
  sender.restart(at_ms(0));
  const auto first = sender.take(at_ms(0), {});
  const auto second = sender.take(at_ms(25), {});
  const auto third = sender.take(at_ms(50), {});
  EXPECT_EQ(sender.take_answer(second), at_ms(25));
  EXPECT_FALSE(sender.take_answer(first)) << "answers do not overtake";
  EXPECT_FALSE(sender.take_answer(second));
  EXPECT_EQ(sender.take_answer(third), at_ms(50));
}

TEST(PingSender, ForgetsPingsThatAreLongUnanswered) {
  PingSender sender({});
  sender.restart(at_ms(0));
  const auto first = sender.take(at_ms(0), {});
  for (int i = 1; i <= 16; ++i) {
    sender.take(at_ms(25 * i), {});
  }
  EXPECT_FALSE(sender.take_answer(first));
}

TEST(PingSender, RefusesAPeriodOfNothing) {
  EXPECT_THROW(PingSender({.period = std::chrono::seconds(0)}), std::invalid_argument);
  EXPECT_THROW(PingSender({.blurred_period = std::chrono::seconds(0)}), std::invalid_argument);
  EXPECT_THROW(PingSender({.spread = std::chrono::seconds(0)}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
