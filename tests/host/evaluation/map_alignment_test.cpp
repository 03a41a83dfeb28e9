// SPDX-License-Identifier: MIT
#include "host/evaluation/map_alignment.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/polygon.hpp"
#include "tests/host/evaluation/cupboard_room.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

/// The room as a robot maps it whose map frame lies at `T_room_map`: cells of 5 cm, a part of the
/// walls not seen.
RasterMap mapped(const Pose2& T_room_map, double seen, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution is_seen(seen);
  RasterMap map(160, 160, 0.05, {-4.0, -4.0});
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d place_m = T_room_map * map.center_m({x, y});
      if (geometry::distance_to_sides_m(kRoom, place_m) < 0.04) {
        map.set({x, y}, is_seen(random) ? CellState::kOccupied : CellState::kUnknown);
      } else if (geometry::contains(kRoom, place_m)) {
        map.set({x, y}, CellState::kFree);
      }
    }
  }
  return map;
}

TEST(MapAlignment, FindsHowTheStartsLieApart) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> metres(-0.7, 0.7);
  std::uniform_real_distribution<double> turns_rad(-0.45, 0.45);
  const auto a = mapped({}, 0.7, 1);
  for (std::uint32_t trial = 0; trial < 4; ++trial) {
    const Pose2 T_a_b(metres(random), metres(random), turns_rad(random));
    const auto alignment = align_maps(a, mapped(T_a_b, 0.7, trial + 2));
    ASSERT_TRUE(alignment) << trial;
    const Pose2 off = T_a_b.inverse() * alignment->T_a_b;
    EXPECT_LT(off.position_m().norm(), 0.04) << trial;
    EXPECT_LT(std::abs(off.heading_rad()), 0.02) << trial;
    EXPECT_GT(alignment->agreement, 0.8) << trial;
  }
}

TEST(MapAlignment, IsEmptyWhereMapsHaveNothingInCommon) {
  const auto room = mapped({}, 0.7, 1);
  const auto post = tests::map_from({"...", ".#.", "..."}, 0.05, {5.0, 5.0});
  EXPECT_FALSE(align_maps(room, post));
  EXPECT_FALSE(align_maps(room, tests::map_from({"..."})));
  EXPECT_FALSE(align_maps(tests::map_from({"..."}), room));
}

TEST(MapAlignment, ChecksItsParameters) {
  MapAlignmentParams params;
  params.wall_stddev_m = 0.0;
  EXPECT_THROW(align_maps(tests::map_from({"#"}), tests::map_from({"#"}), params),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation
