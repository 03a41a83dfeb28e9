// SPDX-License-Identifier: MIT
#include "firmware/tasks/line_budget.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "firmware/hal/uart.hpp"

namespace echomap::tasks {
namespace {

constexpr int kWindowMs = 256;
constexpr std::uint8_t kFrame = 15;

class LineBudgetTest : public testing::Test {
 protected:
  /// A window in which as many frames are taken as there may be, up to `max_bytes`.
  int run_window(int max_bytes) {
    int taken = 0;
    for (int ms = 0; ms < kWindowMs; ++ms) {
      budget.tick();
      while (taken + kFrame <= max_bytes && budget.take(kFrame)) {
        taken += kFrame;
      }
    }
    return taken;
  }
  void run_overloaded_window() {
    budget.overloaded();
    run_window(0);
  }

  const int share_bytes = hal::line_bytes_per_s() * 7 / 10 * kWindowMs / 1000;
  LineBudget budget;
};

TEST_F(LineBudgetTest, LetsAnswersHaveAQuarterOfTheLineAndABurst) {
  const auto take_all = [&] {
    int taken = 0;
    while (budget.take_answer(kFrame)) {
      taken += kFrame;
    }
    return taken;
  };
  EXPECT_EQ(take_all(), LineBudget::kMaxCreditBytes / kFrame * kFrame);
  int taken = 0;
  for (int ms = 0; ms < 10'000; ++ms) {
    budget.tick();
    taken += take_all();
  }
  EXPECT_NEAR(taken, 10 * hal::line_bytes_per_s() / 4, 10 * hal::line_bytes_per_s() / 100);
}

TEST_F(LineBudgetTest, LetsSeventyPercentOfTheLineThroughAndNoMore) {
  int taken = 0;
  for (int window = 0; window < 10; ++window) {
    taken += run_window(INT32_MAX);
  }
  const double seventy_percent = 0.7 * hal::line_bytes_per_s() * 10 * kWindowMs / 1000.0;
  EXPECT_LE(taken, seventy_percent);
  EXPECT_GE(taken, 0.99 * seventy_percent);
}

TEST_F(LineBudgetTest, AnIdleLineSavesUpOneBurst) {
  run_window(0);
  run_window(0);
  int burst = 0;
  while (budget.take(kFrame)) {
    burst += kFrame;
  }
  EXPECT_EQ(burst, LineBudget::kMaxCreditBytes / kFrame * kFrame);
}

TEST_F(LineBudgetTest, StretchesByOneStepForEachWindowWithLosses) {
  budget.overloaded();
  budget.overloaded();
  EXPECT_EQ(budget.rate_step(), 0);
  run_window(0);
  EXPECT_EQ(budget.rate_step(), 1);
  run_window(0);
  EXPECT_EQ(budget.rate_step(), 1);
  for (int i = 0; i < 10; ++i) {
    run_overloaded_window();
  }
  EXPECT_EQ(budget.rate_step(), LineBudget::kMaxRateStep);
}

TEST_F(LineBudgetTest, TakesAStepBackAfterTwoSecondsInWhichTwiceAsMuchWouldFit) {
  run_overloaded_window();
  run_overloaded_window();
  for (int i = 1; i < LineBudget::kQuietWindows; ++i) {
    run_window(share_bytes / 2);
    ASSERT_EQ(budget.rate_step(), 2) << "window " << i;
  }
  run_window(share_bytes / 2);
  EXPECT_EQ(budget.rate_step(), 1);
  for (int i = 0; i < LineBudget::kQuietWindows; ++i) {
    run_window(0);
  }
  EXPECT_EQ(budget.rate_step(), 0);
  for (int i = 0; i < LineBudget::kQuietWindows; ++i) {
    run_window(0);
  }
  EXPECT_EQ(budget.rate_step(), 0);
}

TEST_F(LineBudgetTest, KeepsItsStepWhileMoreThanHalfIsUsedOrSomethingIsLost) {
  run_overloaded_window();
  for (int i = 0; i < 3 * LineBudget::kQuietWindows; ++i) {
    run_window(i % LineBudget::kQuietWindows == 3 ? share_bytes / 2 + kFrame : 0);
  }
  EXPECT_EQ(budget.rate_step(), 1);
  run_overloaded_window();
  for (int i = 1; i < LineBudget::kQuietWindows; ++i) {
    run_window(0);
  }
  EXPECT_EQ(budget.rate_step(), 2) << "the loss began the two seconds anew";
}

}  // namespace
}  // namespace echomap::tasks
