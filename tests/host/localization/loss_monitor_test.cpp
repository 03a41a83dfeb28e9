// SPDX-License-Identifier: MIT
#include "host/localization/loss_monitor.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(LossMonitor, SuspectsReadingsThatHaveBecomeUnlikely) {
  LossMonitor monitor({.fast_share = 0.4, .suspicious_fall = 0.2});
  for (int i = 0; i < 1000; ++i) {
    ASSERT_FALSE(monitor.is_suspicious(-0.5 + 0.3 * (i % 3))) << i;
  }
  int sweeps = 1;
  while (!monitor.is_suspicious(-3.0) && sweeps < 100) {
    ++sweeps;
  }
  EXPECT_LE(sweeps, 2);
}

TEST(LossMonitor, GetsUsedToALikelihoodThatIsLowForLong) {
  LossMonitor monitor({.fast_share = 0.4, .suspicious_fall = 0.2});
  monitor.is_suspicious(0.0);
  for (int i = 0; i < 200; ++i) {
    monitor.is_suspicious(-3.0);
  }
  EXPECT_FALSE(monitor.is_suspicious(-3.0));
}

TEST(LossMonitor, JudgesASuspicionByBayesRule) {
  LossMonitor monitor({.kidnap_chance = 0.1});
  EXPECT_EQ(monitor.lost_probability(), 0.0);
  monitor.suspect();
  EXPECT_NEAR(monitor.lost_probability(), 0.1, 1e-12);
  monitor.compare(std::log(0.2), std::log(0.6));
  EXPECT_NEAR(monitor.lost_probability(), 0.1 * 0.6 / (0.1 * 0.6 + 0.9 * 0.2), 1e-12);
  monitor.clear_suspicion();
  EXPECT_EQ(monitor.lost_probability(), 0.0);
}

TEST(LossMonitor, ForgetsWhatWasUsualWhenItStartsAnew) {
  LossMonitor monitor;
  monitor.is_suspicious(0.0);
  monitor.restart();
  EXPECT_FALSE(monitor.is_suspicious(-5.0));
}

TEST(LossMonitor, RefusesChancesThatAreNone) {
  EXPECT_THROW(LossMonitor({.kidnap_chance = 0.0}), std::invalid_argument);
  EXPECT_THROW(LossMonitor({.slow_share = 1.0}), std::invalid_argument);
  EXPECT_THROW(LossMonitor({.suspicious_fall = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
