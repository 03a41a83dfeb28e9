// SPDX-License-Identifier: MIT
/// A second program at a robot that drives, on the release image.
#include <gtest/gtest.h>

#include "tests/sessions/hijacks.hpp"

namespace echomap::tests {
namespace {

/// `./run bench link` tries a hundred times.
TEST(Hijack, IsRefusedEveryTimeAndNotNoticed) {
  constexpr int kTries = 20;
  const Hijacks result = measure_hijacks(ECHOMAP_BINARY_DIR "/firmware/echomap-uno.elf", kTries);
  EXPECT_EQ(result.tries, kTries);
  EXPECT_EQ(result.refused, kTries);
}

}  // namespace
}  // namespace echomap::tests
