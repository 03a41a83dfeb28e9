// SPDX-License-Identifier: MIT
#include "host/source_search/dwell_lattice.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"

namespace echomap::source_search {
namespace {

/// 6 x 3 m in two halves, with a gap of 0.7 m at the top between them.
tests::SourceWorld two_halves() {
  return tests::SourceWorld({6.0, 3.0}, {{{2.9, 0.0}, {3.1, 2.3}}});
}

TEST(DwellLattice, PlacesAreOpen) {
  const auto world = two_halves();
  const exploration::CostGrid costs(world.map(), {1.0, 1.0}, {});
  const DwellLattice lattice(costs, 0.8);
  EXPECT_GT(lattice.places_m().size(), 20U);
  for (const Eigen::Vector2d& place_m : lattice.places_m()) {
    EXPECT_TRUE(costs.is_open(costs.cell_at(place_m)));
  }
}

TEST(DwellLattice, WaysGoThroughTheGap) {
  const auto world = two_halves();
  const exploration::CostGrid costs(world.map(), {1.0, 0.5}, {});
  const DwellLattice lattice(costs, 0.8);
  const auto tree = lattice.tree_from(costs, {1.0, 0.5});
  double behind_m = 1e9;
  for (std::size_t i = 0; i < lattice.places_m().size(); ++i) {
    if (lattice.places_m()[i].x() > 4.0 && lattice.places_m()[i].y() < 1.0) {
      behind_m = std::min(behind_m, tree.distance_m[i]);
    }
  }
  // 1.9 m up and 2 m to the right at least, and down again.
  EXPECT_GT(behind_m, 4.0);
  EXPECT_LT(behind_m, 7.0);
}

TEST(DwellLattice, NothingIsReachedFromASealedHalf) {
  const tests::SourceWorld world({6.0, 3.0}, {{{2.9, 0.0}, {3.1, 3.0}}});
  const exploration::CostGrid costs(world.map(), {1.0, 0.5}, {});
  const DwellLattice lattice(costs, 0.8);
  const auto tree = lattice.tree_from(costs, {1.0, 0.5});
  for (const std::uint32_t place : tree.order) {
    EXPECT_LT(lattice.places_m()[place].x(), 2.9);
  }
}

TEST(DwellLattice, ParentsAreNearer) {
  const auto world = two_halves();
  const exploration::CostGrid costs(world.map(), {1.0, 0.5}, {});
  const DwellLattice lattice(costs, 0.8);
  const auto tree = lattice.tree_from(costs, {1.0, 0.5});
  for (const std::uint32_t place : tree.order) {
    if (tree.parent[place] >= 0) {
      const auto parent = static_cast<std::size_t>(tree.parent[place]);
      EXPECT_LT(tree.distance_m[parent], tree.distance_m[place]);
    }
  }
}

}  // namespace
}  // namespace echomap::source_search
