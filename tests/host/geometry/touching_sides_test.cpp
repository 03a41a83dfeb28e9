// SPDX-License-Identifier: MIT
#include "host/geometry/touching_sides.hpp"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Polygon kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

/// Of two sides on the lattice that share a corner.
bool lie_on_each_other(const Segment& first, const Segment& second) {
  const Eigen::Vector2d a = first.to_m - first.from_m;
  const Eigen::Vector2d b = second.to_m - second.from_m;
  return cross(a, b) == 0.0 && a.dot(b) < 0.0;
}

/// Every side against every other.
std::vector<TouchingSides> one_by_one(const std::vector<Polygon>& rings) {
  std::vector<RingSide> sides;
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    for (std::size_t i = 0; i < rings[ring].size(); ++i) {
      sides.push_back({ring, i});
    }
  }
  std::vector<TouchingSides> found;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const auto& [a, b] = std::pair(sides[i], sides[k]);
      const std::size_t count = rings[a.ring].size();
      const bool neighbours =
          a.ring == b.ring && ((a.side + 1) % count == b.side || (b.side + 1) % count == a.side);
      const Segment first = side(rings[a.ring], a.side);
      const Segment second = side(rings[b.ring], b.side);
      if (neighbours ? lie_on_each_other(first, second) : touch(first, second)) {
        found.push_back({a, b});
      }
    }
  }
  return found;
}

TEST(TouchingSides, AreNoneOfRingsThatKeepApart) {
  EXPECT_THAT(touching_sides({}), IsEmpty());
  EXPECT_THAT(touching_sides({kSquare, {{0.5, 0.5}, {1, 0.5}, {1, 1}}}), IsEmpty());
}

TEST(TouchingSides, CrossMeetInACornerOrLieOnEachOther) {
  EXPECT_THAT(touching_sides({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}),
              ElementsAre(TouchingSides{{0, 0}, {0, 2}}));
  EXPECT_THAT(touching_sides({kSquare, {{1, 2}, {2, 3}, {0, 3}}}),
              ElementsAre(TouchingSides{{0, 2}, {1, 0}}, TouchingSides{{0, 2}, {1, 2}}));
  EXPECT_THAT(touching_sides({kSquare, {{2, 0.5}, {3, 0.5}, {3, 1}, {2, 1}}}),
              ElementsAre(TouchingSides{{0, 1}, {1, 0}},
                          TouchingSides{{0, 1}, {1, 2}},
                          TouchingSides{{0, 1}, {1, 3}}));
}

TEST(TouchingSides, FollowEachOtherOnlyWhereOneFoldsBack) {
  EXPECT_THAT(touching_sides({{{0, 0}, {2, 0}, {1, 0}, {0, 1}}}),
              ElementsAre(TouchingSides{{0, 0}, {0, 1}}, TouchingSides{{0, 0}, {0, 2}}));
  EXPECT_THAT(touching_sides({{{0, 0}, {1, 0}, {2, 0}, {0, 1}}}), IsEmpty());
}

TEST(TouchingSides, AreThoseThatComparingAllOfThemFinds) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> lattice(0, 12);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Polygon> rings(2);
    for (Polygon& ring : rings) {
      for (int i = 0; i < 3 + trial % 8; ++i) {
        ring.emplace_back(0.25 * lattice(random), 0.25 * lattice(random));
      }
    }
    EXPECT_EQ(touching_sides(rings), one_by_one(rings)) << trial;
  }
}

}  // namespace
}  // namespace echomap::geometry
