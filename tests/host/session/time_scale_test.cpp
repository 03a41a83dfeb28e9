// SPDX-License-Identifier: MIT
#include "host/session/time_scale.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
namespace {

using std::chrono::steady_clock;

/// The wall time that a second of the pace takes.
double wall_seconds(const TimeScale& scale) {
  Cable cable;
  CableStream stream(cable);
  const auto pace = scaled_pace(std::make_unique<CablePace>(cable), scale);
  const auto start = steady_clock::now();
  time::HostTime now;
  while (now < time::HostTime(std::chrono::seconds(1))) {
    now = pace->step(stream, 0, [](auto) {});
  }
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

TEST(TimeScale, NeverRunsAheadOfTheWall) {
  EXPECT_GE(wall_seconds(TimeScale(10.0)), 0.095);
  TimeScale steered(0.0);
  steered.keep_real_time(true);
  EXPECT_GE(wall_seconds(steered), 0.99);
}

TEST(TimeScale, GoesByItsFactorUnlessSomebodySteers) {
  TimeScale scale(8.0);
  EXPECT_EQ(scale.now(), 8.0);
  scale.keep_real_time(true);
  EXPECT_EQ(scale.now(), 1.0);
  scale.set_factor(0.0);
  scale.keep_real_time(false);
  EXPECT_EQ(scale.now(), 0.0);
}

}  // namespace
}  // namespace echomap::session
