// SPDX-License-Identifier: MIT
#include "host/fleet/replay_guard.hpp"

#include <gtest/gtest.h>

namespace echomap::fleet {
namespace {

TEST(ReplayGuard, TakesWhatIsLaterOnItsTopic) {
  ReplayGuard guard;
  EXPECT_EQ(guard.take("claim", {"r1", 1, 5}, false), Freshness::kNew);
  EXPECT_EQ(guard.take("claim", {"r1", 1, 6}, false), Freshness::kNew);
  EXPECT_EQ(guard.take("pose", {"r1", 1, 2}, false), Freshness::kNew) << "another topic";
  EXPECT_EQ(guard.boot_id("r1"), 1U);
}

TEST(ReplayGuard, DistinguishesADuplicateFromAReplay) {
  ReplayGuard guard;
  guard.take("claim", {"r1", 1, 5}, false);
  guard.take("claim", {"r1", 1, 6}, false);
  EXPECT_EQ(guard.take("claim", {"r1", 1, 6}, false), Freshness::kDuplicate);
  EXPECT_EQ(guard.take("claim", {"r1", 1, 5}, false), Freshness::kReplayed);
  EXPECT_EQ(guard.take("claim", {"r1", 1, 5}, true), Freshness::kOutdated);
}

TEST(ReplayGuard, RefusesWhatIsOfAFormerStart) {
  ReplayGuard guard;
  guard.take("claim", {"r1", 2, 1}, false);
  EXPECT_EQ(guard.take("claim", {"r1", 1, 900}, false), Freshness::kOldBoot);
  EXPECT_EQ(guard.take("pose", {"r1", 1, 900}, false), Freshness::kOldBoot);
  EXPECT_EQ(guard.take("graph/0", {"r1", 1, 900}, true), Freshness::kNew)
      << "the broker has kept it, and there is no later one";
  EXPECT_EQ(guard.boot_id("r1"), 2U);
  EXPECT_EQ(guard.take("claim", {"r1", 3, 0}, false), Freshness::kNew) << "it has started again";
  EXPECT_EQ(guard.boot_id("r1"), 3U);
}

TEST(ReplayGuard, KeepsRobotsApart) {
  ReplayGuard guard;
  guard.take("r1/claim", {"r1", 7, 5}, false);
  EXPECT_EQ(guard.take("r2/claim", {"r2", 1, 1}, false), Freshness::kNew);
  EXPECT_EQ(guard.boot_id("r3"), 0U);
}

}  // namespace
}  // namespace echomap::fleet
