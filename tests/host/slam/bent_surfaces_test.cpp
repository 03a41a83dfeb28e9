// SPDX-License-Identifier: MIT
#include "host/slam/bent_surfaces.hpp"

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

std::vector<Pose2> bent_by(double turn_rad) { return {{}, {0.0, 0.0, 3.0 + turn_rad}}; }

TEST(BentSurfaces, AreFoundAgainOnlyWhereTheStopIsBentInANewWay) {
  const mapping::Scan readings = tests::scan_of(tests::smooth_rectangle(), {0.3, 0.1});
  BentSurfaces surfaces;
  const std::size_t found = surfaces.find(bent_by(0.0), readings, {}).surfaces.size();
  ASSERT_GT(found, 2U);
  EXPECT_EQ(surfaces.find(bent_by(0.01), {}, {}).surfaces.size(), found) << "as good as before";
  EXPECT_EQ(surfaces.find(bent_by(0.1), {}, {}).surfaces.size(), 0U) << "of no readings";
  EXPECT_EQ(surfaces.last().surfaces.size(), 0U);
  EXPECT_EQ(surfaces.find(bent_by(0.0), {}, {}).surfaces.size(), found) << "remembered";
  EXPECT_EQ(surfaces.last().surfaces.size(), found);
}

TEST(BentSurfaces, ForgetTheBendThatIsLongestUnused) {
  const mapping::Scan readings = tests::scan_of(tests::smooth_rectangle(), {0.3, 0.1});
  BentSurfaces surfaces;
  surfaces.find(bent_by(0.0), readings, {});
  for (int bend = 1; bend <= 8; ++bend) {
    surfaces.find(bent_by(0.1 * bend), {}, {});
  }
  EXPECT_EQ(surfaces.find(bent_by(0.0), {}, {}).surfaces.size(), 0U) << "of no readings";
}

}  // namespace
}  // namespace echomap::slam
