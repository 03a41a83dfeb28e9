// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_fan.hpp"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/mapping/cells.hpp"

namespace echomap::mapping {
namespace {

const models::SonarCone kFanCone;
const FanRays kRays(kFanCone.params().max_range_m, kCellM);
const SonarView kAhead{{0.0, 0.0}, {{0.0, 2.0}}};

TEST(SonarFan, HoldsPointsInTheConeOnly) {
  const SonarFan fan(kAhead, kFanCone, kRays);
  EXPECT_TRUE(fan.place({1.0, 0.2}));
  EXPECT_TRUE(fan.place({1.0, -0.2}));
  EXPECT_FALSE(fan.place({1.0, 0.4}));
  EXPECT_FALSE(fan.place({-1.0, 0.0}));
  EXPECT_FALSE(fan.place({3.2, 0.0}));
}

TEST(SonarFan, MissesLittleBeforeTheEchoAndAllBehind) {
  const SonarFan fan(kAhead, kFanCone, kRays);
  EXPECT_NEAR(fan.miss_chance(*fan.place({1.0, 0.0})), kFanCone.params().overheard_chance, 1e-6);
  EXPECT_EQ(fan.miss_chance(*fan.place({2.5, 0.0})), 1.0);
}

TEST(SonarFan, BelievesTheBeamThatSaysMost) {
  const SonarView two{{0.0, 0.0}, {{0.0, 1.0}, {0.1, 2.0}}};
  const SonarFan fan(two, kFanCone, kRays);
  EXPECT_LT(fan.miss_chance(*fan.place({1.5, 0.1})), 0.3);
}

TEST(SonarFan, VisitsEveryCellOfItsConesOnceAndNoOther) {
  const SonarView two{{0.01, 0.02}, {{3.1, 1.0}, {0.3, std::nullopt}}};
  const SonarFan fan(two, kFanCone, kRays);
  const CellField field({{-80, -80}, {80, 80}}, kCellM);
  std::vector<int> visits(field.size());
  fan.for_cells(field, [&](geometry::CellIndex cell, const SonarFan::Place&) {
    ++visits[field.index(cell)];
  });
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto place = fan.place(field.center_m(field.cell(i)));
    const bool is_spoken_of = place && fan.miss_chance(*place) < 1.0;
    ASSERT_EQ(visits[i], is_spoken_of ? 1 : 0) << i;
  }
}

TEST(SonarFan, DoesNotGetThroughAWall) {
  SonarFan fan(kAhead, kFanCone, kRays);
  fan.look([](const Eigen::Vector2d& point_m) {
    return point_m.x() > 1.0 && point_m.x() < 1.05 ? 0.9 : 0.0;
  });
  EXPECT_NEAR(fan.reached(*fan.place({0.9, 0.0}), 0.0), 1.0, 1e-6);
  EXPECT_NEAR(fan.reached(*fan.place({1.5, 0.0}), 0.0), 0.1, 1e-6);
  EXPECT_NEAR(fan.reached(*fan.place({1.04, 0.0}), kCellM), 1.0, 1e-6);
}

}  // namespace
}  // namespace echomap::mapping
