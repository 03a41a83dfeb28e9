// SPDX-License-Identifier: MIT
#include "hil_mock/world/noise.hpp"

#include <cmath>
#include <cstdint>
#include <set>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

TEST(NoiseStream, RepeatsWithItsSeed) {
  NoiseStream first(5, NoisePurpose::kBody);
  NoiseStream second(5, NoisePurpose::kBody);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(first.normal(), second.normal());
  }
}

TEST(NoiseStream, GivesTheValuesOfEveryMachine) {
  NoiseStream noise(1, NoisePurpose::kSonar);
  EXPECT_EQ(noise.uniform() * 4294967296.0, 917361018.0);
  EXPECT_EQ(noise.uniform() * 4294967296.0, 3549904078.0);
}

TEST(NoiseStream, PurposesAndSeedsDiffer) {
  NoiseStream body(1, NoisePurpose::kBody);
  NoiseStream sonar(1, NoisePurpose::kSonar);
  NoiseStream next(2, NoisePurpose::kBody);
  const double value = body.uniform();
  EXPECT_NE(value, sonar.uniform());
  EXPECT_NE(value, next.uniform());
}

TEST(NoiseStream, IsUniformAndNormal) {
  constexpr int kDraws = 200000;
  NoiseStream noise(3, NoisePurpose::kBody);
  double uniform_sum = 0.0;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double uniform = noise.uniform();
    ASSERT_GE(uniform, 0.0);
    ASSERT_LT(uniform, 1.0);
    uniform_sum += uniform;
    const double normal = noise.normal();
    sum += normal;
    sum_of_squares += normal * normal;
    beyond_two += std::abs(normal) > 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(uniform_sum / kDraws, 0.5, 0.003);
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0, 0.02);
  EXPECT_NEAR(beyond_two / static_cast<double>(kDraws), 0.0455, 0.002);
}

TEST(SeedOf, TheFirstHasTheSharedOneAndTheOthersHaveOthers) {
  EXPECT_EQ(seed_of(7, 0), 7U);
  std::set<std::uint32_t> seeds;
  for (std::uint32_t shared = 0; shared < 50; ++shared) {
    for (std::uint32_t number = 1; number < 16; ++number) {
      seeds.insert(seed_of(shared, number));
    }
  }
  EXPECT_EQ(seeds.size(), 50U * 15U);
  EXPECT_EQ(seed_of(7, 3), seed_of(7, 3));
}

}  // namespace
}  // namespace echomap::world
