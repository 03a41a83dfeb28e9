// SPDX-License-Identifier: MIT
#include "host/exploration/same_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"

namespace echomap::exploration {
namespace {

using tests::scan_of;

TEST(SameView, HearsAgainWhatItHasHeardFromThere) {
  const auto room = tests::smooth_rectangle();
  auto noisy = scan_of(room);
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    if (noisy[i].range_m) {
      *noisy[i].range_m += i % 2 == 0 ? 0.03 : -0.03;
    }
  }
  EXPECT_TRUE(is_same_view(scan_of(room), noisy));
}

TEST(SameView, HearsOthersAFewSpansAway) {
  const auto room = tests::smooth_rectangle();
  EXPECT_FALSE(is_same_view(scan_of(room), scan_of(room, {0.25, 0.0})));
  EXPECT_FALSE(is_same_view(scan_of(room), scan_of(room, {0.2, 0.2})));
}

TEST(SameView, KnowsNothingOfSilence) {
  const auto room = tests::smooth_rectangle();
  EXPECT_FALSE(is_same_view(scan_of({}), scan_of({})));
  EXPECT_FALSE(is_same_view(scan_of(room), scan_of({})));
  EXPECT_FALSE(is_same_view({}, {}));
}

}  // namespace
}  // namespace echomap::exploration
