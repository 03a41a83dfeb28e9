// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fleet_load.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

/// One robot: a pose each second, and something to keep.
LoadRecord record_of_a_minute() {
  LoadRecord record;
  record.duration_s = 60.0;
  record.robots.resize(1);
  for (int second = 0; second < 60; ++second) {
    record.robots[0].push_back({1.0 * second, "pose", 56, mqtt::Delivery::kAtMostOnce, false});
    record.robots[0].push_back({1.0 * second, "graph", 300, mqtt::Delivery::kAtLeastOnce, true});
  }
  return record;
}

TEST(FleetLoad, EveryDeliveryOfAShortReplayIsCounted) {
  const LoadResult all = measure_load({3, 2.0, true, 1}, record_of_a_minute());
  EXPECT_GE(all.published_per_s, 3.0);
  EXPECT_EQ(all.missing, 0U);
  EXPECT_NEAR(all.delivered_per_s, 4.0 * all.published_per_s, 1e-9);
  EXPECT_GT(all.p99_ms, 0.0);
  const LoadResult hub = measure_load({3, 2.0, false, 1}, record_of_a_minute());
  EXPECT_NEAR(hub.delivered_per_s, hub.published_per_s, 1e-9);
}

TEST(FleetLoad, RobotsTakeTheRobotsOfTheRecordInTurn) {
  LoadRecord record;
  record.duration_s = 0.5;
  record.robots = {{{0.0, "pose", 50, mqtt::Delivery::kAtMostOnce, false}},
                   {{0.0, "claim", 1000, mqtt::Delivery::kAtLeastOnce, false}}};
  const LoadResult two = measure_load({2, 2.0, false, 1}, record);
  EXPECT_NEAR(two.published_per_s, 4.0, 1.1);
  EXPECT_GT(two.kbytes_per_s_per_robot, 0.7) << "half of them are large";
}

TEST(FleetLoad, ARecordOfNothingIsRefused) {
  EXPECT_THROW(measure_load({2, 1.0, false, 1}, {}), std::invalid_argument);
  EXPECT_THROW(measure_load({2, 1.0, false, 1}, {10.0, {{}}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench
