// SPDX-License-Identifier: MIT
#include "host/slam/provisional_landmarks.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

LandmarkSighting labelled_point(double range_m, double bearing_rad, int label = 0) {
  LandmarkSighting seen;
  seen.value = {range_m, bearing_rad};
  seen.label = label;
  return seen;
}

const ProvisionalLandmarksParams thrice{.sightings = 3, .forgotten_after_scans = 2};

TEST(ProvisionalLandmarks, RefuseADistanceOfNothing) {
  EXPECT_THROW(ProvisionalLandmarks({.max_m = 0.0}), std::invalid_argument);
}

TEST(ProvisionalLandmarks, AreConfirmedOnceSeenOftenEnoughFromWhereverTheRobotIs) {
  ProvisionalLandmarks landmarks(thrice);

  EXPECT_TRUE(landmarks.confirmed(std::vector{labelled_point(5.0, 0.0)}, {}).empty());
  EXPECT_TRUE(landmarks.confirmed(std::vector{labelled_point(4.0, 0.0)}, {1.0, 0.0, 0.0}).empty());
  EXPECT_EQ(landmarks.confirmed(std::vector{labelled_point(4.1, 0.5)}, {1.0, 0.0, -0.5}).size(),
            1U);
  EXPECT_EQ(landmarks.waiting(), 0U);
}

TEST(ProvisionalLandmarks, AreNotConfirmedByWhatMoves) {
  ProvisionalLandmarks landmarks(thrice);
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(landmarks.confirmed(std::vector{labelled_point(5.0 - 0.4 * i, 0.0)}, {}).empty());
  }
}

TEST(ProvisionalLandmarks, AreForgottenWhenTheyAreNotSeenAgain) {
  ProvisionalLandmarks landmarks(thrice);
  landmarks.confirmed(std::vector{labelled_point(5.0, 0.0)}, {});
  for (int i = 0; i < 3; ++i) {
    landmarks.confirmed({}, {});
  }

  EXPECT_EQ(landmarks.waiting(), 0U);
}

TEST(ProvisionalLandmarks, CountOneSightingAScan) {
  ProvisionalLandmarks landmarks(thrice);
  const std::vector<LandmarkSighting> close{
      labelled_point(5.0, 0.0), labelled_point(5.1, 0.0), labelled_point(5.0, 0.01)};

  EXPECT_TRUE(landmarks.confirmed(close, {}).empty());
  EXPECT_EQ(landmarks.waiting(), 3U);
}

TEST(ProvisionalLandmarks, AreOfOneKindAndLabel) {
  ProvisionalLandmarks landmarks({.sightings = 2});
  LandmarkSighting wall = labelled_point(5.0, 0.0);
  wall.kind = LandmarkKind::kWall;
  landmarks.confirmed(std::vector{labelled_point(5.0, 0.0, 1)}, {});

  EXPECT_TRUE(landmarks.confirmed(std::vector{labelled_point(5.0, 0.0, 2), wall}, {}).empty());
  EXPECT_EQ(landmarks.confirmed(std::vector{wall}, {}).size(), 1U);
}

}  // namespace
}  // namespace echomap::slam
