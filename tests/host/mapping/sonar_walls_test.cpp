// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_walls.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

const double kHalfRad = radians(15.0);

/// What a sonar at (x, 0) hears of a smooth wall along y = 1: one range, wherever the foot of the
/// perpendicular is in the cone.
SonarView beside_wall(double x_m, bool wall_is_there = true) {
  SonarView view{{x_m, 0.0}, {}};
  for (int degree = 0; degree <= 180; degree += 10) {
    const bool hears = wall_is_there && std::abs(degree - 90) <= 15;
    view.beams.push_back({radians(degree), hears ? std::optional(1.0) : std::nullopt});
  }
  return view;
}

std::vector<geometry::Segment> walls_of(const std::vector<SonarView>& views) {
  return find_sonar_walls(views, kHalfRad, 3.0, {});
}

TEST(SonarWalls, JoinTheFeetOfTwoViews) {
  const auto walls = walls_of({beside_wall(0.0), beside_wall(0.8)});
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_TRUE(walls[0].from_m.isApprox(Eigen::Vector2d(0.0, 1.0), 1e-9));
  EXPECT_TRUE(walls[0].to_m.isApprox(Eigen::Vector2d(0.8, 1.0), 1e-9));
}

TEST(SonarWalls, LeaveADoorOpenThatAViewHasSeen) {
  EXPECT_TRUE(walls_of({beside_wall(0.0), beside_wall(0.6, false), beside_wall(1.2)}).empty());
}

TEST(SonarWalls, ReachNoFartherThanADoorIsWide) {
  EXPECT_TRUE(walls_of({beside_wall(0.0), beside_wall(1.7)}).empty());
}

TEST(SonarWalls, NeedAllReadingsOfAViewToAgree) {
  auto view = beside_wall(0.8);
  for (sensors::Beam& beam : view.beams) {
    if (std::abs(beam.bearing_rad - radians(100.0)) < 0.01) {
      beam.range_m = 2.0;
    }
  }
  EXPECT_TRUE(walls_of({beside_wall(0.0), view}).empty());
}

/// Two sonars that look ahead at a slant towards a post at (2, 1.2), behind the wall along y = 1.
std::vector<SonarView> towards_post() {
  std::vector<SonarView> views;
  for (const double x_m : {0.1, 0.5}) {
    const Eigen::Vector2d to_post_m = Eigen::Vector2d(2.0, 1.2) - Eigen::Vector2d(x_m, 0.0);
    views.push_back({{x_m, 0.0}, {{radians(35.0), to_post_m.norm()}}});
  }
  return views;
}

TEST(SonarWalls, DoNotStandBehindOthers) {
  auto views = towards_post();
  ASSERT_EQ(walls_of(views).size(), 1U);
  for (double x_m = 1.0; x_m < 2.0; x_m += 0.3) {
    views.push_back(beside_wall(x_m));
  }
  const auto walls = walls_of(views);
  EXPECT_GE(walls.size(), 3U);
  for (const geometry::Segment& wall : walls) {
    EXPECT_NEAR(wall.from_m.y(), 1.0, 1e-9);
    EXPECT_NEAR(wall.to_m.y(), 1.0, 1e-9);
  }
}

TEST(SonarWalls, AreNoneBetweenTwoRangesWithoutTangent) {
  SonarView one{{0.0, 0.0}, {{radians(90.0), 0.5}}};
  SonarView other{{0.8, 0.0}, {{radians(90.0), 1.5}}};
  EXPECT_TRUE(walls_of({one, other}).empty());
}

}  // namespace
}  // namespace echomap::mapping
