// SPDX-License-Identifier: MIT
#include "host/sensors/tick_unwrapper.hpp"

#include <random>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

std::int16_t on_the_wire(std::int64_t ticks) { return static_cast<std::int16_t>(ticks); }

TEST(TickUnwrapper, FollowsEveryStepShorterThanHalfAWrap) {
  for (const int start : {-32768, -1, 0, 1, 32767}) {
    for (int step = -32767; step <= 32767; ++step) {
      TickUnwrapper unwrapper;
      ASSERT_EQ(unwrapper.unwrap(on_the_wire(start)), 0);
      ASSERT_EQ(unwrapper.unwrap(on_the_wire(start + step)), step);
    }
  }
}

TEST(TickUnwrapper, FollowsARandomWalkOverManyWraps) {
  std::mt19937 random(2);
  TickUnwrapper unwrapper;
  std::int64_t truth = 0;
  unwrapper.unwrap(0);
  std::int64_t farthest = 0;
  for (int i = 0; i < 100'000; ++i) {
    truth += static_cast<std::int64_t>(random() % 60'000) - 27'300;
    ASSERT_EQ(unwrapper.unwrap(on_the_wire(truth)), truth);
    farthest = std::max(farthest, truth);
  }
  EXPECT_GT(farthest, 10 * 65'536);
}

TEST(TickUnwrapper, GoesOnThroughAReset) {
  TickUnwrapper unwrapper;
  unwrapper.unwrap(30'000);
  unwrapper.unwrap(31'000);
  unwrapper.restart();
  EXPECT_EQ(unwrapper.unwrap(5), 1'005);
  EXPECT_EQ(unwrapper.unwrap(-5), 995);
}

}  // namespace
}  // namespace echomap::sensors
