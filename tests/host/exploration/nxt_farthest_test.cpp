// SPDX-License-Identifier: MIT
#include "host/exploration/nxt_farthest.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::radians;
using mapping::Scan;

/// An open floor, 8 m x 8 m around the start, known to be free.
std::shared_ptr<const mapping::OccupancyGrid> open_floor() {
  auto grid = std::make_shared<mapping::OccupancyGrid>();
  for (int y = -80; y < 80; ++y) {
    for (int x = -80; x < 80; ++x) {
      grid->add({x, y}, -200);
    }
  }
  return grid;
}

/// What the explorer sees from `T_map_robot` with echoes at these bearings (map frame, degrees).
pipeline::Snapshot seen(const std::map<double, double>& range_by_bearing_deg,
                        const geometry::Pose2& T_map_robot = {}) {
  Scan scan;
  mapping::PointCloudMap points;
  for (const auto& [bearing_deg, range_m] : range_by_bearing_deg) {
    const geometry::Pose2 T_map_sonar(T_map_robot.x_m(), T_map_robot.y_m(), radians(bearing_deg));
    scan.push_back({T_map_robot, T_map_sonar, range_m});
    points.add(scan.back());
  }
  pipeline::Snapshot snapshot;
  snapshot.latest.T_map_robot = T_map_robot;
  snapshot.trajectory = std::make_shared<const std::vector<pipeline::StampedPose>>();
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(points);
  static const auto floor = open_floor();
  snapshot.grid = floor;
  snapshot.last_scan = std::make_shared<const Scan>(scan);
  snapshot.stops = 1;
  snapshot.newly_free_m2 = 1.0;
  return snapshot;
}

/// Motions up to and including EndScan.
std::vector<Motion> sensing(NxtFarthest& explorer, const pipeline::Snapshot& snapshot) {
  std::vector<Motion> motions;
  do {
    motions.push_back(explorer.next(snapshot, MotionResult::kReached));
  } while (!std::holds_alternative<EndScan>(motions.back()));
  return motions;
}

const std::map<double, double> kFiveWays{
    {0.0, 3.0}, {72.0, 2.8}, {144.0, 2.6}, {-144.0, 2.4}, {-72.0, 1.0}};

TEST(NxtFarthest, ReadsTwiceAllAroundInStepsOfSixDegrees) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  double heading_deg = 0.0;
  std::multiset<int> bearings_deg;
  const auto motions = sensing(explorer, seen({}));
  EXPECT_TRUE(std::holds_alternative<BeginScan>(motions.front()));
  for (const Motion& motion : motions) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      heading_deg += degrees(turn->angle_rad);
    } else if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      const int last =
          static_cast<int>(std::lround((sweep->to_rad - sweep->from_rad) / sweep->step_rad));
      for (int i = 0; i <= last; ++i) {
        const double bearing_deg = heading_deg + degrees(sweep->from_rad + i * sweep->step_rad);
        bearings_deg.insert(static_cast<int>(std::lround(bearing_deg + 720.0)) % 360);
        EXPECT_LE(std::abs(sweep->from_rad + i * sweep->step_rad), radians(90.0) + 1e-9);
      }
    }
  }
  EXPECT_EQ(bearings_deg.size(), 120U);
  for (int bearing_deg = 0; bearing_deg < 360; bearing_deg += 6) {
    EXPECT_EQ(bearings_deg.count(bearing_deg), 2U) << bearing_deg;
  }
}

TEST(NxtFarthest, NeedsNoTurnOfTheBodyWhereThePanGoesAllRound) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.sweep.pan_limit_rad = std::numbers::pi;
  NxtFarthest explorer(params, random);
  for (const Motion& motion : sensing(explorer, seen({}))) {
    EXPECT_FALSE(std::holds_alternative<Turn>(motion));
  }
}

TEST(NxtFarthest, TurnsToOneOfTheFourFarthestAndGoesHalfTheWay) {
  std::set<int> chosen_deg;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    NxtFarthest explorer({}, random);
    const auto snapshot = seen(kFiveWays);
    sensing(explorer, snapshot);
    const auto turn = std::get<Turn>(explorer.next(snapshot, MotionResult::kReached));
    const auto drive = std::get<Drive>(explorer.next(snapshot, MotionResult::kReached));
    const int bearing_deg = static_cast<int>(std::lround(degrees(turn.angle_rad)));
    chosen_deg.insert(bearing_deg);
    EXPECT_NEAR(drive.distance_m, 0.5 * kFiveWays.at(bearing_deg), 1e-9);
  }
  EXPECT_EQ(chosen_deg, (std::set<int>{0, 72, 144, -144}));
}

TEST(NxtFarthest, TakesReadingsWithinABeamForOneCandidate) {
  // The four farthest readings are one and the same door; the others are walls.
  const std::map<double, double> door_and_walls{
      {0.0, 3.9}, {6.0, 3.8}, {-6.0, 3.7}, {12.0, 3.6}, {90.0, 2.0}, {-90.0, 1.9}, {180.0, 1.8}};
  std::set<int> chosen_deg;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    NxtFarthest explorer({}, random);
    const auto snapshot = seen(door_and_walls);
    sensing(explorer, snapshot);
    const auto turn = std::get<Turn>(explorer.next(snapshot, MotionResult::kReached));
    chosen_deg.insert(static_cast<int>(std::lround(degrees(turn.angle_rad))));
  }
  EXPECT_EQ(chosen_deg, (std::set<int>{0, 90, -90, 180}));
}

TEST(NxtFarthest, StopsShortOfWhatItSees) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.candidates = 1;
  NxtFarthest explorer(params, random);
  // Something stands one metre ahead, a little to the side of the way to the farthest echo.
  const auto snapshot = seen({{0.0, 3.0}, {4.0, 1.0}});
  sensing(explorer, snapshot);
  explorer.next(snapshot, MotionResult::kReached);
  const auto drive = std::get<Drive>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_LT(drive.distance_m, 1.0 - params.robot_radius_m);
  EXPECT_GT(drive.distance_m, 0.7);
}

TEST(NxtFarthest, DrivesOnlyWhereTheMapIsFree) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.candidates = 1;
  NxtFarthest explorer(params, random);
  auto snapshot = seen({{0.0, 3.0}});
  auto grid = std::make_shared<mapping::OccupancyGrid>(*snapshot.grid);
  grid->add(grid->cell_at({0.9, 0.0}), 600);
  snapshot.grid = grid;
  sensing(explorer, snapshot);
  explorer.next(snapshot, MotionResult::kReached);
  const auto drive = std::get<Drive>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_NEAR(drive.distance_m, 0.9 - params.robot_radius_m - params.clearance_m, 0.06);
}

TEST(NxtFarthest, PrefersWhereItHasNotBeen) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.candidates = 1;
  NxtFarthest explorer(params, random);
  auto snapshot = seen({{0.0, 3.0}, {90.0, 2.0}});
  mapping::PointCloudMap points = *snapshot.points;
  points.add({geometry::Pose2(1.4, 0.1, 0.0), geometry::Pose2(), std::nullopt});
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(points);
  sensing(explorer, snapshot);
  const auto turn = std::get<Turn>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_NEAR(turn.angle_rad, radians(90.0), 1e-9);
}

TEST(NxtFarthest, NeverTurnsThroughItsBack) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.candidates = 1;
  NxtFarthest explorer(params, random);
  const auto snapshot = seen({{-170.0, 2.0}}, {0.0, 0.0, radians(170.0)});
  const auto motions = sensing(explorer, snapshot);
  const auto in_scan = std::find_if(motions.begin(), motions.end(), [](const Motion& motion) {
    return std::holds_alternative<Turn>(motion);
  });
  EXPECT_LT(std::get<Turn>(*in_scan).angle_rad, 0.0);
  const auto turn = std::get<Turn>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_NEAR(turn.angle_rad, radians(-340.0), 1e-9);
}

TEST(NxtFarthest, BacksOffFromABumpAndReadsAgain) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  const auto snapshot = seen(kFiveWays);
  sensing(explorer, snapshot);
  explorer.next(snapshot, MotionResult::kReached);
  EXPECT_GT(std::get<Drive>(explorer.next(snapshot, MotionResult::kReached)).distance_m, 0.0);
  EXPECT_LT(std::get<Drive>(explorer.next(snapshot, MotionResult::kBumped)).distance_m, 0.0);
  EXPECT_TRUE(std::holds_alternative<BeginScan>(explorer.next(snapshot, MotionResult::kReached)));
}

TEST(NxtFarthest, ReadsAgainEvenWhereItCannotBackOff) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  const auto snapshot = seen(kFiveWays);
  sensing(explorer, snapshot);
  explorer.next(snapshot, MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<Drive>(explorer.next(snapshot, MotionResult::kStalled)));
  EXPECT_TRUE(std::holds_alternative<BeginScan>(explorer.next(snapshot, MotionResult::kStalled)));
}

TEST(NxtFarthest, GoesOnReadingAfterABumpInAScan) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  const auto snapshot = seen(kFiveWays);
  explorer.next(snapshot, MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<Sweep>(explorer.next(snapshot, MotionResult::kBumped)));
}

TEST(NxtFarthest, ReadsAgainWhereAMoveWasInterrupted) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  sensing(explorer, seen(kFiveWays));
  explorer.next(seen(kFiveWays), MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<BeginScan>(
      explorer.next(seen(kFiveWays), MotionResult::kInterrupted)));
}

TEST(NxtFarthest, EndsWhenNoSweepOfAStopWasCarriedOut) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  Motion motion = explorer.next(seen({}), MotionResult::kReached);
  while (!std::holds_alternative<Finished>(motion)) {
    motion = explorer.next(
        seen({}),
        std::holds_alternative<Sweep>(motion) ? MotionResult::kRefused : MotionResult::kReached);
  }
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kCannotSense);
}

TEST(NxtFarthest, EndsAfterSoManyStops) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.max_stops = 3;
  NxtFarthest explorer(params, random);
  auto snapshot = seen(kFiveWays);
  snapshot.stops = 3;
  sensing(explorer, snapshot);
  const auto finished = std::get<Finished>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_EQ(finished.reason, FinishReason::kStopLimit);
}

TEST(NxtFarthest, EndsWhenTwoStopsInARowShowNoNewGround) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  auto snapshot = seen(kFiveWays);
  const std::vector<double> newly_free_m2{5.0, 0.01, 0.5, 0.01};
  for (const double area_m2 : newly_free_m2) {
    snapshot.newly_free_m2 = area_m2;
    sensing(explorer, snapshot);
    ASSERT_TRUE(std::holds_alternative<Turn>(explorer.next(snapshot, MotionResult::kReached)));
    explorer.next(snapshot, MotionResult::kReached);
  }
  sensing(explorer, snapshot);
  const auto finished = std::get<Finished>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_EQ(finished.reason, FinishReason::kNoNewGround);
}

TEST(NxtFarthest, ScansTheRoomAgainWithAsManyStopsAsAtFirst) {
  std::mt19937 random(1);
  NxtFarthestParams params;
  params.scans = 3;
  NxtFarthest explorer(params, random);
  auto snapshot = seen(kFiveWays);
  snapshot.newly_free_m2 = 0.0;
  snapshot.stops = 0;
  Motion motion;
  do {
    ++snapshot.stops;
    sensing(explorer, snapshot);
    motion = explorer.next(snapshot, MotionResult::kReached);
    explorer.next(snapshot, MotionResult::kReached);
  } while (std::holds_alternative<Turn>(motion) && snapshot.stops < 20);
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kNoNewGround);
  EXPECT_EQ(snapshot.stops, 6U) << "three times the two stops that found nothing new";
}

TEST(NxtFarthest, EndsWhereItHearsNothing) {
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  const auto snapshot = seen({});
  sensing(explorer, snapshot);
  const auto finished = std::get<Finished>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_EQ(finished.reason, FinishReason::kNowhereToGo);
}

TEST(NxtFarthest, EndsWhereItIsWalledIn) {
  std::map<double, double> walls;
  for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 6) {
    walls[bearing_deg] = 0.2;
  }
  std::mt19937 random(1);
  NxtFarthest explorer({}, random);
  const auto snapshot = seen(walls);
  sensing(explorer, snapshot);
  const auto finished = std::get<Finished>(explorer.next(snapshot, MotionResult::kReached));
  EXPECT_EQ(finished.reason, FinishReason::kNowhereToGo);
}

TEST(NxtFarthest, RefusesParametersWithoutSense) {
  std::mt19937 random(1);
  const auto refused = [&](auto change) {
    NxtFarthestParams params;
    change(params);
    EXPECT_THROW(NxtFarthest(params, random), std::invalid_argument);
  };
  refused([](auto& params) { params.sweep.step_rad = 0.0; });
  refused([](auto& params) { params.sweep.scan_rad = 1.0; });
  refused([](auto& params) { params.candidates = 0; });
  refused([](auto& params) { params.drive_share = 1.5; });
  refused([](auto& params) { params.max_stops = 0; });
  refused([](auto& params) { params.scans = 0; });
  refused([](auto& params) { params.robot_radius_m = 0.0; });
}

}  // namespace
}  // namespace echomap::exploration
