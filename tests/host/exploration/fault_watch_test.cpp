// SPDX-License-Identifier: MIT
#include "host/exploration/fault_watch.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using mapping::ScanFault;

/// Drives on and on, or ends where `end` is set, and notes what it is told.
class Driver final : public Explorer {
 public:
  Driver(std::vector<MotionResult>& told, const std::optional<FinishReason>& end)
      : told_(told), end_(end) {}
  Motion next(const pipeline::Snapshot& /*snapshot*/, MotionResult last) override {
    told_.push_back(last);
    return end_ ? Motion(Finished{*end_}) : Motion(Drive{0.5});
  }

 private:
  std::vector<MotionResult>& told_;
  const std::optional<FinishReason>& end_;
};

class FaultWatchTest : public ::testing::Test {
 protected:
  Motion after(MotionResult last) { return watch.next(snapshot, last); }
  Motion after_scan(ScanFault fault) {
    return after_scan_of(mapping::Scan(30, {{}, {}, 1.0}), fault);
  }
  Motion after_scan_of(const mapping::Scan& scan, ScanFault fault = ScanFault::kNone) {
    ++snapshot.stops;
    snapshot.last_scan = std::make_shared<const mapping::Scan>(scan);
    snapshot.last_scan_fault = fault;
    return after(MotionResult::kReached);
  }
  static bool drives(const Motion& motion) { return std::holds_alternative<Drive>(motion); }
  static std::optional<FinishReason> reason(const Motion& motion) {
    const auto* finished = std::get_if<Finished>(&motion);
    return finished ? std::optional(finished->reason) : std::nullopt;
  }
  static double turn_rad(const Motion& motion) {
    const auto* turn = std::get_if<Turn>(&motion);
    return turn ? turn->angle_rad : 0.0;
  }

  std::vector<MotionResult> told;
  std::optional<FinishReason> end;  ///< Of the strategy.
  pipeline::Snapshot snapshot = tests::snapshot_of(mapping::OccupancyGrid());
  FaultWatch watch{std::make_unique<Driver>(told, end)};
};

TEST_F(FaultWatchTest, LeavesARobotWithoutFaultToItsStrategy) {
  EXPECT_TRUE(drives(after(MotionResult::kReached)));
  EXPECT_TRUE(drives(after(MotionResult::kBumped)));
  EXPECT_TRUE(drives(after_scan(ScanFault::kNone)));
  EXPECT_EQ(told,
            (std::vector{MotionResult::kReached, MotionResult::kBumped, MotionResult::kReached}));
}

TEST_F(FaultWatchTest, ASonarThatHangsEndsIt) {
  EXPECT_EQ(reason(after_scan(ScanFault::kStuck)), FinishReason::kSonarStuck);
  EXPECT_TRUE(told.empty());
}

TEST_F(FaultWatchTest, ATurnAllRoundThatTheSonarDoesNotAnswerIsADeadSonar) {
  const mapping::Scan silent(30, {{}, {}, std::nullopt, false});
  EXPECT_TRUE(drives(after_scan_of(silent))) << "a loose contact";
  EXPECT_TRUE(drives(after_scan(ScanFault::kNone)));
  EXPECT_TRUE(drives(after_scan_of(silent)));
  EXPECT_EQ(reason(after_scan_of(silent)), FinishReason::kSonarSilent);
}

TEST_F(FaultWatchTest, ASonarThatListensInVainIsNotDead) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(drives(after_scan_of(mapping::Scan(90, {{}, {}, std::nullopt})))) << i;
  }
}

TEST_F(FaultWatchTest, ThreeScansOfAnotherPlaceInARowMeanThatItIsLost) {
  EXPECT_TRUE(drives(after_scan(ScanFault::kElsewhere)));
  EXPECT_TRUE(drives(after_scan(ScanFault::kElsewhere)));
  EXPECT_TRUE(drives(after(MotionResult::kReached))) << "the same scan";
  EXPECT_TRUE(drives(after_scan(ScanFault::kNone)));
  EXPECT_TRUE(drives(after_scan(ScanFault::kElsewhere)));
  EXPECT_TRUE(drives(after_scan(ScanFault::kElsewhere)));
  const Motion motion = after_scan(ScanFault::kElsewhere);
  EXPECT_EQ(reason(motion), FinishReason::kLost);
  EXPECT_EQ(std::get<Finished>(motion).stops_elsewhere, 3U);
}

TEST_F(FaultWatchTest, AMapThatTheLastTwoScansContradictIsNotCalledComplete) {
  EXPECT_TRUE(drives(after_scan(ScanFault::kElsewhere)));
  end = FinishReason::kNoNewGround;
  const Motion motion = after_scan(ScanFault::kElsewhere);
  EXPECT_EQ(reason(motion), FinishReason::kLost);
  EXPECT_EQ(std::get<Finished>(motion).stops_elsewhere, 2U);
}

TEST_F(FaultWatchTest, AStrategyEndsAfterOneScanOfAnotherPlaceOrForAReasonOfItsOwn) {
  end = FinishReason::kComplete;
  EXPECT_EQ(reason(after_scan(ScanFault::kElsewhere)), FinishReason::kComplete);
  end = FinishReason::kStopLimit;
  EXPECT_EQ(reason(after_scan(ScanFault::kElsewhere)), FinishReason::kStopLimit);
}

/// Readings all round, of which so many end on the floor of `walled_floor` and the rest at its
/// wall.
mapping::Scan with_echoes_on_floor(int on_floor) {
  mapping::Scan scan;
  for (int i = 0; i < 40; ++i) {
    const geometry::Pose2 T_map_sonar(0.0, 0.0, 0.157 * i);
    scan.push_back({{}, T_map_sonar, i < on_floor ? 0.7 : 1.5});
  }
  return scan;
}

/// Floor all round as far as 1.5 m, and a wall behind it.
std::shared_ptr<const mapping::OccupancyGrid> walled_floor() {
  auto grid = std::make_shared<mapping::OccupancyGrid>();
  for (geometry::CellIndex cell{-40, -40}; cell.y < 40; ++cell.y) {
    for (cell.x = -40; cell.x < 40; ++cell.x) {
      grid->add(cell, grid->center_m(cell).norm() < 1.5 ? -400 : 400);
    }
  }
  return grid;
}

class FaultWatchOfAMovedMapTest : public FaultWatchTest {
 protected:
  /// So many echoes on floor of the map before, and none in the one after it.
  Motion after_doubt(int on_floor) {
    snapshot.grid = walled_floor();
    after(MotionResult::kReached);
    snapshot.grid = std::make_shared<const mapping::OccupancyGrid>();
    return after_scan_of(with_echoes_on_floor(on_floor));
  }
};

TEST_F(FaultWatchOfAMovedMapTest, ThreeScansWithAThirdOfTheirEchoesOnFloorMeanThatItIsLost) {
  EXPECT_TRUE(drives(after_doubt(14)));
  EXPECT_TRUE(drives(after_doubt(14)));
  EXPECT_TRUE(drives(after_doubt(13))) << "a door that was open";
  EXPECT_TRUE(drives(after_doubt(14)));
  EXPECT_TRUE(drives(after_doubt(14)));
  EXPECT_EQ(reason(after_doubt(14)), FinishReason::kLost);
}

TEST_F(FaultWatchOfAMovedMapTest, IsNotBentWhereItIsRightNow) {
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(drives(after_doubt(12))) << i;
  }
}

TEST_F(FaultWatchTest, AScanThatWasRefusedIsNotHeldAgainstTheMap) {
  snapshot.grid = walled_floor();
  EXPECT_TRUE(drives(after(MotionResult::kReached)));
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(drives(after_scan_of(with_echoes_on_floor(0))));
  }
  EXPECT_TRUE(drives(after_scan_of(with_echoes_on_floor(36), ScanFault::kElsewhere)));
  EXPECT_TRUE(drives(after_scan_of(with_echoes_on_floor(0))));
}

TEST_F(FaultWatchTest, AMapThatManyScansContradictIsBent) {
  snapshot.grid = walled_floor();
  EXPECT_TRUE(drives(after(MotionResult::kReached)));
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(drives(after_scan_of(with_echoes_on_floor(2))));
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(drives(after_scan_of(with_echoes_on_floor(6)))) << i;
  }
  const Motion motion = after_scan_of(with_echoes_on_floor(6));
  EXPECT_EQ(reason(motion), FinishReason::kLost);
  EXPECT_EQ(std::get<Finished>(motion).stops_elsewhere, 4U);
}

TEST_F(FaultWatchTest, WheelsThatStallAreTriedToAndFroBeforeTheyAreBroken) {
  const double there_rad = turn_rad(after(MotionResult::kStalled));
  EXPECT_GT(there_rad, 0.2);
  EXPECT_EQ(turn_rad(after(MotionResult::kStalled)), -there_rad);
  EXPECT_EQ(reason(after(MotionResult::kTimedOut)), FinishReason::kWheelFault);
  EXPECT_TRUE(told.empty());
}

TEST_F(FaultWatchTest, WheelsThatTurnWhenTheyAreTriedGoOnWithTheStrategy) {
  EXPECT_NE(turn_rad(after(MotionResult::kTimedOut)), 0.0);
  EXPECT_TRUE(drives(after(MotionResult::kReached)));
  EXPECT_EQ(told, std::vector{MotionResult::kTimedOut}) << "what its own motion came to";
  EXPECT_NE(turn_rad(after(MotionResult::kStalled)), 0.0) << "and tries them again";
  EXPECT_NE(turn_rad(after(MotionResult::kStalled)), 0.0);
  EXPECT_TRUE(drives(after(MotionResult::kReached)));
}

TEST_F(FaultWatchTest, RefusesWhatHasNoSense) {
  FaultWatchParams params;
  params.scans_elsewhere = 0;
  EXPECT_THROW(FaultWatch(std::make_unique<Driver>(told, end), params), std::invalid_argument);
  EXPECT_THROW(FaultWatch(nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
