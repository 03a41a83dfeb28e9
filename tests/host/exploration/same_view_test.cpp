// SPDX-License-Identifier: MIT
#include "host/exploration/same_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"

namespace echomap::exploration {
namespace {

using tests::scan_of;

/// The same read by a body that faces there.
mapping::Scan with_body(mapping::Scan scan, double heading_rad) {
  for (mapping::PlacedReading& reading : scan) {
    const Eigen::Vector2d at_m = reading.T_map_robot.position_m();
    reading.T_map_robot = {at_m.x(), at_m.y(), heading_rad};
  }
  return scan;
}

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

TEST(SameView, HearsAgainWhatItHeardWhereItsWheelsTurnedAndItDidNot) {
  const auto room = tests::smooth_rectangle();
  const auto before = with_body(scan_of(room, {0.3, 0.1}), 0.0);
  const geometry::Pose2 T_believed_true(0.2, 0.1, 2.0);
  EXPECT_TRUE(is_same_view(before, with_body(moved(before, T_believed_true), 2.0)));
  EXPECT_FALSE(is_same_view(before, with_body(scan_of(room, {-0.1, 0.3}), 2.0)));
}

TEST(SameView, KnowsNothingOfSilence) {
  const auto room = tests::smooth_rectangle();
  EXPECT_FALSE(is_same_view(scan_of({}), scan_of({})));
  EXPECT_FALSE(is_same_view(scan_of(room), scan_of({})));
  EXPECT_FALSE(is_same_view({}, {}));
}

}  // namespace
}  // namespace echomap::exploration
