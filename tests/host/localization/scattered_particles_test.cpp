// SPDX-License-Identifier: MIT
#include "host/localization/scattered_particles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

const mapping::RasterMap kHalfKnownRooms =
    tests::map_from({"#######", "#..#..#", "#..#  #", "#######"}, 0.5, {-1.0, 2.0});

TEST(ScatteredParticles, StandOnFreeCellsOnly) {
  std::mt19937 random(1);
  const Particles particles = scattered_particles(kHalfKnownRooms, 2000, random);
  ASSERT_EQ(particles.size(), 2000U);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    ASSERT_EQ(kHalfKnownRooms.state(kHalfKnownRooms.cell_at(particles.pose(i).position_m())),
              mapping::CellState::kFree);
    ASSERT_EQ(particles.log_weight[i], 0.0F);
  }
}

TEST(ScatteredParticles, AreAsManyEverywhereAndInEveryHeading) {
  std::mt19937 random(1);
  constexpr std::size_t kCount = 60'000;
  const Particles particles = scattered_particles(kHalfKnownRooms, kCount, random);
  std::size_t right = 0;
  std::size_t lower_half = 0;
  std::size_t backwards = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    right += particles.x_m[i] > 0.75F ? 1 : 0;
    const auto in_row = particles.y_m[i] - std::floor(2.0F * particles.y_m[i]) / 2.0F;
    lower_half += in_row < 0.25F ? 1 : 0;
    backwards += std::abs(particles.heading_rad[i]) > 1.5707963F ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(right) / kCount, 1.0 / 3.0, 0.01);
  EXPECT_NEAR(static_cast<double>(lower_half) / kCount, 0.5, 0.01);
  EXPECT_NEAR(static_cast<double>(backwards) / kCount, 0.5, 0.01);
}

TEST(ScatteredParticles, AreNoneWhereThereIsNoFloor) {
  std::mt19937 random(1);
  EXPECT_EQ(scattered_particles(mapping::RasterMap(3, 3, 0.1, {0.0, 0.0}), 10, random).size(), 0U);
}

}  // namespace
}  // namespace echomap::localization
