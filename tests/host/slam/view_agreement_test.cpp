// SPDX-License-Identifier: MIT
#include "host/slam/view_agreement.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

using Eigen::Vector2d;

/// A wall 4 m ahead of a sensor that stands 1 m before the middle of the robot; to its left
/// nothing answers.
sensors::RangeScan wall_ahead() {
  return {{}, {1.0, 0.0, 0.0}, {{-0.01, 4.0}, {0.0, 4.0}, {0.01, 4.0}, {1.0, std::nullopt}}};
}

ViewAgreement seen(const Vector2d& point_m) {
  return view_agreement(wall_ahead(), std::vector<Vector2d>{point_m}, 0.3);
}

TEST(ViewAgreement, APointOnTheWallIsMet) { EXPECT_EQ(seen({4.9, 0.0}).met, 1U); }

TEST(ViewAgreement, APointBeforeTheWallIsSeenThrough) {
  EXPECT_EQ(seen({3.0, 0.0}).through, 1U);
  EXPECT_EQ(seen({3.0, 0.0}).met, 0U);
}

TEST(ViewAgreement, WhatIsHiddenBesideOrUnansweredDoesNotCount) {
  for (const Vector2d& point_m : {Vector2d(8.0, 0.0), Vector2d(3.0, 1.0), Vector2d(2.0, 1.6)}) {
    EXPECT_EQ(seen(point_m).met + seen(point_m).through, 0U) << point_m.transpose();
  }
}

TEST(ViewAgreement, BeamsMayComeInAnyOrder) {
  for (const double bearing_rad : {-1.5, 0.0, 0.5}) {
    const sensors::RangeScan clockwise{
        {}, {}, {{0.5, 4.0}, {0.0, 4.0}, {-0.8, std::nullopt}, {-1.5, 4.0}}, 0.0, 8.0};
    const auto views = view_agreement(
        clockwise, std::vector{Vector2d(2.0 * geometry::unit_vector(bearing_rad))}, 0.3);
    EXPECT_EQ(views.through, 1U) << bearing_rad;
  }
}

TEST(ViewAgreement, BearingsMayGoOnPastHalfATurn) {
  constexpr double kBehind = std::numbers::pi;
  const sensors::RangeScan round{
      {}, {}, {{0.0, 4.0}, {kBehind - 0.004, 4.0}, {1.5 * kBehind, 4.0}}, 0.0, 8.0};
  for (const double bearing_rad : {kBehind - 0.01, 0.004 - kBehind, -0.5 * kBehind}) {
    const auto views =
        view_agreement(round, std::vector{Vector2d(2.0 * geometry::unit_vector(bearing_rad))}, 0.3);
    EXPECT_EQ(views.through, 1U) << bearing_rad;
  }
}

TEST(ViewAgreement, TellsTheShareThatCannotBe) {
  ViewAgreement views{3, 0};
  views += {0, 1};
  EXPECT_DOUBLE_EQ(views.contradicted_share(), 0.25);
  EXPECT_DOUBLE_EQ(ViewAgreement{}.contradicted_share(), 0.0);
}

}  // namespace
}  // namespace echomap::slam
