// SPDX-License-Identifier: MIT
#include "host/slam/landmark_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

using geometry::Segment;

/// A laser of 361 beams over 180 degrees at the origin, among walls.
sensors::RangeScan scan_of(const std::vector<Segment>& walls) {
  sensors::RangeScan scan;
  scan.max_range_m = 30.0;
  for (int i = 0; i <= 360; ++i) {
    const double bearing_rad = geometry::radians(-90.0 + 0.5 * i);
    std::optional<double> nearest_m;
    for (const Segment& wall : walls) {
      const auto range_m =
          geometry::ray_distance_m({0.0, 0.0}, geometry::unit_vector(bearing_rad), wall);
      if (range_m && (!nearest_m || *range_m < *nearest_m)) {
        nearest_m = range_m;
      }
    }
    scan.beams.push_back({bearing_rad, nearest_m});
  }
  return scan;
}

std::vector<LandmarkSighting> of_label(const std::vector<LandmarkSighting>& all,
                                       LandmarkKind kind,
                                       int label) {
  std::vector<LandmarkSighting> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const auto& sighting) {
    return sighting.kind == kind && sighting.label == label;
  });
  return chosen;
}

Eigen::Vector2d place_m(const LandmarkSighting& point) {
  return point.value.x() * geometry::unit_vector(point.value.y());
}

/// The right wall, the one ahead, and the corner between.
const std::vector<Segment> corner_of_a_room{{{-1.0, -2.0}, {4.0, -2.0}}, {{4.0, -2.0}, {4.0, 3.0}}};

TEST(LandmarkExtraction, FindsTheWallsOfARoom) {
  const auto walls = of_label(extract_landmarks(scan_of(corner_of_a_room)), LandmarkKind::kWall, 0);

  ASSERT_EQ(walls.size(), 2U);
  EXPECT_NEAR(walls[0].value.x(), 2.0, 0.01);
  EXPECT_NEAR(walls[0].value.y(), -std::numbers::pi / 2.0, 0.01);
  EXPECT_NEAR(walls[1].value.x(), 4.0, 0.01);
  EXPECT_NEAR(walls[1].value.y(), 0.0, 0.01);
  EXPECT_NEAR(walls[1].along_from_m, -2.0, 0.1);
  EXPECT_NEAR(walls[1].along_to_m, 3.0, 0.1);
}

TEST(LandmarkExtraction, FindsTheCornerBetweenThem) {
  const auto corners =
      of_label(extract_landmarks(scan_of(corner_of_a_room)), LandmarkKind::kPoint, kInnerCorner);

  ASSERT_EQ(corners.size(), 1U);
  EXPECT_LT((place_m(corners[0]) - Eigen::Vector2d(4.0, -2.0)).norm(), 0.03);
}

TEST(LandmarkExtraction, TellsAnOuterCornerFromAnInnerOne) {
  const auto corners =
      of_label(extract_landmarks(scan_of({{{1.0, -3.0}, {2.0, -0.5}}, {{2.0, -0.5}, {1.0, 2.0}}})),
               LandmarkKind::kPoint,
               kInnerCorner);
  const auto outer =
      of_label(extract_landmarks(scan_of({{{4.0, -2.0}, {2.0, 0.3}}, {{2.0, 0.3}, {4.0, 2.0}}})),
               LandmarkKind::kPoint,
               kOuterCorner);

  EXPECT_EQ(corners.size(), 1U);
  ASSERT_EQ(outer.size(), 1U);
  EXPECT_LT((place_m(outer[0]) - Eigen::Vector2d(2.0, 0.3)).norm(), 0.03);
}

TEST(LandmarkExtraction, FindsAPostBeforeAWall) {
  const auto posts =
      of_label(extract_landmarks(scan_of({{{5.0, -3.0}, {5.0, 3.0}}, {{2.0, -0.06}, {2.0, 0.06}}})),
               LandmarkKind::kPoint,
               kPost);

  ASSERT_EQ(posts.size(), 1U);
  EXPECT_NEAR(posts[0].value.y(), 0.0, 0.01);
  EXPECT_NEAR(posts[0].value.x(), 2.0, 0.12);
}

TEST(LandmarkExtraction, FindsNothingWhereNothingAnswers) {
  EXPECT_TRUE(extract_landmarks(scan_of({})).empty());
  EXPECT_TRUE(extract_landmarks(sensors::RangeScan{}).empty());
}

TEST(LandmarkExtraction, FindsOnlyWhatItIsToldTo) {
  LandmarkExtractionParams params;
  params.with_walls = false;
  params.with_corners = false;
  params.with_posts = false;

  EXPECT_TRUE(extract_landmarks(scan_of(corner_of_a_room), params).empty());
}

TEST(LandmarkExtraction, KeepsWhereTheSensorSits) {
  sensors::RangeScan scan = scan_of(corner_of_a_room);
  const auto without = extract_landmarks(scan);
  scan.T_robot_sensor = {0.2, 0.1, 0.3};
  const auto with = extract_landmarks(scan);

  ASSERT_EQ(with.size(), without.size());
  EXPECT_EQ(with[0].value, without[0].value);
  EXPECT_EQ(with[0].T_robot_sensor.heading_rad(), 0.3);
}

}  // namespace
}  // namespace echomap::slam
