// SPDX-License-Identifier: MIT
#include "host/diagnosis/sonar_check.hpp"

#include <gtest/gtest.h>

namespace echomap::diagnosis {
namespace {

/// What a ping brings: an echo, nothing in reach, or not even an answer.
const sensors::SonarObservation kWall{{}, {}, 0.0, 1.2, true};
const sensors::SonarObservation kNothing{{}, {}, 0.0, std::nullopt, true};
const sensors::SonarObservation kNoAnswer{{}, {}, 0.0, std::nullopt, false};

TEST(SonarCheck, NamesADeadSonarAtItsThirdPing) {
  SonarCheck check;
  check.on_sonar(kNoAnswer);
  check.on_sonar(kNoAnswer);
  EXPECT_FALSE(check.is_dead());
  check.on_sonar(kNoAnswer);
  EXPECT_TRUE(check.is_dead());
  check.on_sonar(kWall);
  EXPECT_FALSE(check.is_dead());
}

TEST(SonarCheck, NeverTakesAHallForOne) {
  SonarCheck check;
  for (int ping = 0; ping < 1000; ++ping) {
    check.on_sonar(kNothing);
    EXPECT_FALSE(check.is_dead());
  }
}

TEST(SonarCheck, TakesAPingThatWasMissedForNoFault) {
  SonarCheck check;
  for (int ping = 0; ping < 100; ++ping) {
    check.on_sonar(ping % 3 == 2 ? kNothing : kNoAnswer);
    EXPECT_FALSE(check.is_dead());
  }
}

}  // namespace
}  // namespace echomap::diagnosis
