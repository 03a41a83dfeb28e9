// SPDX-License-Identifier: MIT
#include "host/mapping/bearing_profile.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/mapping/profile_at.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

constexpr double kUnlimitedM = std::numeric_limits<double>::infinity();

TEST(BearingProfile, NumbersStepsFromMinusPiOn) {
  EXPECT_EQ(BearingProfile::index(-std::numbers::pi), 0U);
  EXPECT_EQ(BearingProfile::index(std::numbers::pi), BearingProfile::kBearings - 1);
  for (const std::size_t index : {std::size_t{0}, std::size_t{360}, std::size_t{719}}) {
    EXPECT_EQ(BearingProfile::index(BearingProfile::bearing_rad(index)), index);
  }
}

TEST(BearingProfile, VisitsEachStepAboutABearingOnceAcrossTheSeam) {
  std::set<std::size_t> visited;
  BearingProfile::visit_about(radians(180.0), radians(1.0), [&](std::size_t index) {
    EXPECT_TRUE(visited.insert(index).second) << index;
  });
  EXPECT_EQ(visited, (std::set<std::size_t>{0, 1, 718, 719}));
}

TEST(HeardWithin, TakesTheNearestOfTheLooksAbout) {
  const auto heard_m =
      heard_within({{0.0, 2.0}, {radians(8.0), 1.0}, {radians(90.0), std::nullopt}}, radians(5.0));
  EXPECT_EQ(at(heard_m, 1.0), 2.0);
  EXPECT_EQ(at(heard_m, 4.0), 1.0);
  EXPECT_EQ(at(heard_m, 90.0), kUnlimitedM);
  EXPECT_EQ(at(heard_m, 45.0), 0.0);
}

}  // namespace
}  // namespace echomap::mapping
