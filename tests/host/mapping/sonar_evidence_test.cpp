// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_evidence.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

const models::SonarCone kCone;
const SonarConeMapperParams kMapperParams;

SonarEvidence evidence_of(const std::vector<SonarView>& views,
                          const std::vector<geometry::Segment>& walls) {
  SonarEvidence evidence(views, walls, kCone, kMapperParams);
  evidence.find();
  return evidence;
}

int centilogits_at(const OccupancyGrid& grid, double x_m, double y_m) {
  return grid.centilogits(grid.cell_at({x_m, y_m})).value_or(0);
}

const std::vector<SonarView> kSilence{{{0.0, 0.0}, {{0.0, std::nullopt}}}};
const geometry::Segment kWallSegment{{1.025, -0.6}, {1.025, 0.6}};

TEST(SonarEvidence, CallsFloorFreeByTheEquationOfTheModel) {
  const auto grid = evidence_of(kSilence, {}).grid();
  EXPECT_NEAR(centilogits_at(grid, 2.0, 0.01), 100.0 * std::log(0.2), kStepCentilogits);
}

TEST(SonarEvidence, StopsSilenceAtAWall) {
  const auto grid = evidence_of(kSilence, {kWallSegment}).grid();
  EXPECT_LT(centilogits_at(grid, 0.8, 0.0), -140);
  EXPECT_GT(centilogits_at(grid, 1.025, 0.0), 0);
  EXPECT_GT(centilogits_at(grid, 2.0, 0.0), -20);
}

TEST(SonarEvidence, GivesAnArcsEvidenceToWhereNobodySeesThrough) {
  const SonarView hears{{0.0, 0.0}, {{0.0, 1.0}}};
  const SonarView sees_through{{0.0, -0.3}, {{0.0, 2.0}}};
  const auto alone = evidence_of({hears}, {}).grid();
  const auto together = evidence_of({hears, sees_through}, {}).grid();
  EXPECT_GT(centilogits_at(together, 0.97, 0.22), centilogits_at(alone, 0.97, 0.22));
  EXPECT_LT(centilogits_at(together, 0.97, -0.22), 0);
}

TEST(SonarEvidence, LeavesTheFloorUnderTheRobotFree) {
  const SonarView behind{{0.2, 0.0}, {{0.0, 1.0}}, Eigen::Vector2d(0.0, 0.0)};
  const auto grid = evidence_of({behind}, {}).grid();
  EXPECT_LT(centilogits_at(grid, 0.05, -0.05), -200);
  EXPECT_EQ(centilogits_at(grid, -0.15, 0.0), 0);
}

TEST(SonarEvidence, CountsAnEchoBehindAWallOnce) {
  const auto counts = evidence_of({{{0.0, 0.0}, {{0.0, 2.0}}}}, {kWallSegment}).counts();
  EXPECT_EQ(counts, (SonarReadingCounts{1, 0, 1, 0}));
}

TEST(SonarEvidence, RefusesViewsTooFarApart) {
  const std::vector<SonarView> views{{{0.0, 0.0}, {{0.0, 1.0}}}, {{1e6, 1e6}, {{0.0, 1.0}}}};
  EXPECT_THROW(SonarEvidence(views, {}, kCone, kMapperParams), std::length_error);
}

}  // namespace
}  // namespace echomap::mapping
