// SPDX-License-Identifier: MIT
#include "host/mqtt/backoff.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/thrown_text.hpp"

namespace echomap::mqtt {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;

const Backoff::Clock::time_point backoff_start{seconds(1000)};

std::vector<long> waits_ms(Backoff& backoff, int failures) {
  std::vector<long> waits;
  for (int i = 0; i < failures; ++i) {
    backoff.note_failed(backoff_start);
    waits.push_back(std::chrono::duration_cast<milliseconds>(backoff.wait()).count());
  }
  return waits;
}

TEST(Backoff, TheFirstAttemptIsAtOnce) {
  EXPECT_TRUE(Backoff(BackoffParams{}, 1).is_due(backoff_start));
}

TEST(Backoff, WaitsDoubleUpToTheLongest) {
  Backoff backoff({0.1, 0.5, 2.0, 0.0, 5.0}, 1);
  EXPECT_THAT(waits_ms(backoff, 5), ElementsAre(100, 200, 400, 500, 500));
  EXPECT_FALSE(backoff.is_due(backoff_start + milliseconds(499)));
  EXPECT_TRUE(backoff.is_due(backoff_start + milliseconds(500)));
}

TEST(Backoff, OnlyASteadyConnectionEndsTheSeries) {
  Backoff backoff({0.1, 10.0, 2.0, 0.0, 5.0}, 1);
  waits_ms(backoff, 3);
  backoff.note_connected(backoff_start - seconds(1));
  EXPECT_THAT(waits_ms(backoff, 1), ElementsAre(800));
  backoff.note_connected(backoff_start - seconds(6));
  EXPECT_THAT(waits_ms(backoff, 2), ElementsAre(100, 200));
}

TEST(Backoff, JitterIsBySeedAndNeverLengthensAWait) {
  const BackoffParams params{1.0, 1.0, 1.0, 0.5, 5.0};
  Backoff one(params, 1);
  Backoff same(params, 1);
  Backoff other(params, 2);
  const std::vector<long> waits = waits_ms(one, 20);
  EXPECT_EQ(waits, waits_ms(same, 20));
  EXPECT_NE(waits, waits_ms(other, 20));
  EXPECT_THAT(waits, testing::Each(testing::AllOf(testing::Ge(500), testing::Le(1000))));
}

TEST(Backoff, RefusesParametersOutsideOfTheirRange) {
  EXPECT_EQ(tests::thrown_text<std::invalid_argument>([] {
              Backoff({0.1, 0.05, 2.0, 0.0, 5.0}, 1);
            }),
            "back-off: max_s = 0.05 is outside 0.1 .. 3600");
}

}  // namespace
}  // namespace echomap::mqtt
