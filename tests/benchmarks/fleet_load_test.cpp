// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fleet_load.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TEST(FleetLoad, TheRecordIsInItsOrderAndHasEveryStop) {
  const auto record = record_of_a_robot();
  EXPECT_TRUE(std::ranges::is_sorted(record, {}, &RecordedMessage::at_s));
  EXPECT_EQ(std::ranges::count(record, "graph", &RecordedMessage::kind), 19);
  EXPECT_EQ(std::ranges::count(record, "pose", &RecordedMessage::kind), 346);
}

TEST(FleetLoad, EveryDeliveryOfAShortReplayIsCounted) {
  const LoadResult all = measure_load({3, 2.0, true, 1}, record_of_a_robot());
  EXPECT_GE(all.published_per_s, 3.0);
  EXPECT_EQ(all.missing, 0U);
  EXPECT_NEAR(all.delivered_per_s, 4.0 * all.published_per_s, 1e-9);
  EXPECT_GT(all.p99_ms, 0.0);
  const LoadResult hub = measure_load({3, 2.0, false, 1}, record_of_a_robot());
  EXPECT_NEAR(hub.delivered_per_s, hub.published_per_s, 1e-9);
}

}  // namespace
}  // namespace echomap::bench
