// SPDX-License-Identifier: MIT
#include "host/apps/counted_encounters.hpp"

#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

/// Waits for another one in each of its motions.
class Waiting {
 public:
  explicit Waiting(std::size_t bumps) { encounters_.bumps = bumps; }
  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/,
                           exploration::MotionResult /*last*/) {
    ++encounters_.waits;
    return exploration::Stand{0.4};
  }
  exploration::Intent intent() const { return {}; }
  const team_exploration::Encounters& encounters() const { return encounters_; }
  bool is_in_deadlock() const { return encounters_.waits == 1; }

 private:
  team_exploration::Encounters encounters_;
};

TEST(CountedEncounters, AreAddedUpOverAllThatDroveInTurn) {
  MemberEncounters encounters;
  {
    CountedEncounters<Waiting> first(encounters, 2);
    first.next({}, exploration::MotionResult::kReached);
    EXPECT_EQ(encounters.counts.waits, 0U) << "told at the end";
  }
  EXPECT_TRUE(encounters.ended_in_deadlock);
  {
    CountedEncounters<Waiting> second(encounters, 1);
    second.next({}, exploration::MotionResult::kReached);
    second.next({}, exploration::MotionResult::kReached);
  }
  EXPECT_EQ(encounters.counts.waits, 3U);
  EXPECT_EQ(encounters.counts.bumps, 3U);
  EXPECT_FALSE(encounters.ended_in_deadlock) << "of the last";
}

}  // namespace
}  // namespace echomap::apps
