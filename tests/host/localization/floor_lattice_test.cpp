// SPDX-License-Identifier: MIT
#include "host/localization/floor_lattice.hpp"

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

TEST(FloorLattice, StandsOnTheFloorOnly) {
  const Particles lattice =
      floor_lattice(tests::map_from({"#.. ", "#..#", "####"}, 0.1, {2.0, 3.0}), 0.1, 1.5708);
  std::set<std::pair<float, float>> places;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    places.insert({lattice.x_m[i], lattice.y_m[i]});
  }
  EXPECT_EQ(lattice.size(), 16U);
  EXPECT_EQ(places.size(), 4U);
  EXPECT_NEAR(places.begin()->first, 2.15F, 1e-5F);
  EXPECT_NEAR(places.begin()->second, 3.15F, 1e-5F);
}

TEST(FloorLattice, StandsInPassagesThatAreThinnerThanItsSteps) {
  const Particles lattice =
      floor_lattice(tests::map_from({"####", "####", "....", "####"}, 0.1), 0.4, 6.2832);
  ASSERT_EQ(lattice.size(), 1U);
  EXPECT_NEAR(lattice.x_m[0], 0.25F, 1e-5F);
  EXPECT_NEAR(lattice.y_m[0], 0.15F, 1e-5F);
}

TEST(FloorLattice, StandsInTheMiddleOfAnOpenFloor) {
  const Particles lattice =
      floor_lattice(tests::map_from({"....", "....", "....", "...."}, 0.1), 0.4, 6.2832);
  ASSERT_EQ(lattice.size(), 1U);
  EXPECT_NEAR(lattice.x_m[0], 0.25F, 1e-5F);
  EXPECT_NEAR(lattice.y_m[0], 0.25F, 1e-5F);
}

TEST(FloorLattice, IsEmptyWithoutFloor) {
  EXPECT_EQ(floor_lattice(tests::map_from({"## ", "   "}), 0.1, 0.1).size(), 0U);
}

}  // namespace
}  // namespace echomap::localization
