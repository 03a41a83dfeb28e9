// SPDX-License-Identifier: MIT
#include "firmware/tasks/scheduler.hpp"

#include <gtest/gtest.h>

namespace echomap::tasks {
namespace {

TEST(Scheduler, HandsOnEveryTickHoweverLate) {
  Scheduler scheduler;
  EXPECT_FALSE(scheduler.take_tick());
  for (int i = 0; i < 200; ++i) {
    scheduler.on_tick();
  }
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(scheduler.has_tick());
    EXPECT_TRUE(scheduler.take_tick());
  }
  EXPECT_FALSE(scheduler.has_tick());
  EXPECT_FALSE(scheduler.take_tick());
}

TEST(Scheduler, ControlIsDueOncePerPeriodThroughTheWrap) {
  Scheduler scheduler;
  for (int period = 0; period < 500; ++period) {
    int due = 0;
    for (int i = 0; i < control::kControlPeriodMs; ++i) {
      scheduler.on_tick();
      ASSERT_TRUE(scheduler.take_tick());
      due += scheduler.control_is_due() ? 1 : 0;
    }
    ASSERT_EQ(due, 1);
  }
}

}  // namespace
}  // namespace echomap::tasks
