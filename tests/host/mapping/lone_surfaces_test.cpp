// SPDX-License-Identifier: MIT
#include "host/mapping/lone_surfaces.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/host/mapping/cells.hpp"

namespace echomap::mapping {
namespace {

constexpr int kDoubt = 200;

/// A wall of 40 cm, 1 m to the right of the stop.
const LoneSurface kLoneWall{{0.0, 0.0}, {0.0, 1.0, 0.2, 10}, kDoubt};

int at(const LoneSurfaces& lone, double x_m, double y_m) {
  return lone.centilogits(cell_around(x_m, y_m));
}

TEST(LoneSurfaces, DoubtsTheFloorRightBehindAFaceOnce) {
  LoneSurfaces lone({}, kCellM);
  lone.set(0, {kLoneWall});
  EXPECT_EQ(at(lone, 1.02, 0.02), kDoubt);
  EXPECT_EQ(at(lone, 1.12, -0.17), kDoubt);
  EXPECT_EQ(at(lone, 0.97, 0.02), 0) << "before it";
  EXPECT_EQ(at(lone, 1.22, 0.02), 0) << "deeper";
  EXPECT_EQ(at(lone, 1.02, 0.27), 0) << "beyond its end";
}

TEST(LoneSurfaces, SumsStopsAndTakesBackWhatIsExplained) {
  LoneSurfaces lone({}, kCellM);
  lone.set(0, {kLoneWall});
  lone.set(1, {kLoneWall});
  EXPECT_EQ(at(lone, 1.02, 0.02), 2 * kDoubt);
  lone.set(0, {});
  EXPECT_EQ(at(lone, 1.02, 0.02), kDoubt);
  lone.resize(1);
  EXPECT_EQ(at(lone, 1.02, 0.02), 0);
}

TEST(LoneSurfaces, DoWithoutASurfaceThatNoMemoryWouldReach) {
  LoneSurfaces lone({}, kCellM);
  lone.set(0, {kLoneWall});
  LoneSurface far = kLoneWall;
  far.center_m = {1e7, 0.0};
  lone.set(1, {far});
  lone.set(1, {});
  EXPECT_EQ(at(lone, 1.02, 0.02), kDoubt);
}

}  // namespace
}  // namespace echomap::mapping
