// SPDX-License-Identifier: MIT
#include "host/mapping/floor_evidence.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/host/mapping/cells.hpp"

namespace echomap::mapping {
namespace {

const FloorEvidenceParams kFloorParams;

FloorReach disc(double heard_m, double silent_m) {
  return {BearingProfile(heard_m), BearingProfile(silent_m)};
}

int at(const FloorEvidence& evidence, double x_m, double y_m) {
  return evidence.centilogits(cell_around(x_m, y_m));
}

void expect_equal(const FloorEvidence& one, const FloorEvidence& other) {
  for (std::int32_t y = -60; y < 60; ++y) {
    for (std::int32_t x = -60; x < 60; ++x) {
      ASSERT_EQ(one.centilogits({x, y}), other.centilogits({x, y})) << x << ' ' << y;
    }
  }
}

FloorReach ragged(std::mt19937& random) {
  std::uniform_real_distribution<double> distance_m(0.0, 2.5);
  FloorReach reach;
  for (std::size_t i = 0; i < BearingProfile::kBearings; ++i) {
    reach.heard_m[i] = i % 30 == 0 || i == 0 ? distance_m(random) : reach.heard_m[i - 1];
    reach.silent_m[i] = reach.heard_m[i] + (i % 30 == 0 ? 0.0 : 0.3);
  }
  return reach;
}

TEST(FloorEvidence, IsFullUpToEchoesAndLessWhereOnlySilenceTells) {
  FloorEvidence evidence(kFloorParams, kCellM);
  evidence.set(0, {0.0, 0.0}, disc(1.0, 2.0));
  EXPECT_EQ(at(evidence, 0.52, 0.02), evidence.faded(std::hypot(0.525, 0.025)));
  EXPECT_NEAR(at(evidence, 1.52, 0.02), kFloorParams.silent_share * evidence.faded(1.525), 1.0);
  EXPECT_EQ(at(evidence, 2.12, 0.02), 0);
}

TEST(FloorEvidence, SumsStopsAndForgetsThoseThatAreGone) {
  FloorEvidence evidence(kFloorParams, kCellM);
  evidence.set(0, {0.0, 0.0}, disc(1.0, 1.0));
  evidence.set(1, {0.0, 0.0}, disc(1.0, 1.0));
  const int of_two = at(evidence, 0.5, 0.0);
  evidence.resize(1);
  EXPECT_EQ(2 * at(evidence, 0.5, 0.0), of_two);
  evidence.resize(0);
  EXPECT_EQ(at(evidence, 0.5, 0.0), 0);
}

TEST(FloorEvidence, IsTheSameAfterManyChangesAsAtOnce) {
  std::mt19937 random(5);
  FloorEvidence changed(kFloorParams, kCellM);
  FloorReach last;
  for (int i = 0; i < 5; ++i) {
    last = ragged(random);
    changed.set(0, {0.1, -0.2}, last);
  }
  FloorEvidence at_once(kFloorParams, kCellM);
  at_once.set(0, {0.1, -0.2}, last);
  expect_equal(changed, at_once);
}

TEST(FloorEvidence, GrowsWithoutLosingWhatItHas) {
  std::mt19937 random(7);
  const FloorReach reach = ragged(random);
  FloorEvidence grown(kFloorParams, kCellM);
  grown.set(0, {0.1, -0.2}, reach);
  FloorEvidence at_once = grown;
  grown.set(1, {-10.0, 7.0}, disc(1.0, 1.0));
  expect_equal(grown, at_once);
  EXPECT_GT(at(grown, -10.0, 7.0), 0);
}

TEST(FloorEvidence, DoesWithoutAStopThatNoMemoryWouldReach) {
  FloorEvidence evidence(kFloorParams, kCellM);
  evidence.set(0, {0.0, 0.0}, disc(1.0, 1.0));
  for (const double far_m : {1e3, 1e7, 1e12}) {
    evidence.set(1, {far_m, far_m}, disc(1.0, 1.0));
    EXPECT_LT(evidence.bounds().columns(), 1000) << far_m;
    EXPECT_GT(at(evidence, 0.0, 0.0), 0);
  }
}

TEST(FloorEvidence, MovesWithItsStop) {
  std::mt19937 random(6);
  const FloorReach reach = ragged(random);
  FloorEvidence moved(kFloorParams, kCellM);
  moved.set(0, {0.4, 0.4}, ragged(random));
  moved.set(0, {0.1, -0.2}, reach);
  FloorEvidence at_once(kFloorParams, kCellM);
  at_once.set(0, {0.1, -0.2}, reach);
  expect_equal(moved, at_once);
}

}  // namespace
}  // namespace echomap::mapping
