// SPDX-License-Identifier: MIT
#include "host/diagnosis/self_check.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/world/floor_plan_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::diagnosis {
namespace {

using exploration::BeginScan;
using exploration::Drive;
using exploration::EndScan;
using exploration::Motion;
using exploration::MotionResult;
using exploration::Sweep;
using exploration::Turn;

/// A simulated robot that stops round about at four places of the living room.
class CheckedRobot {
 public:
  explicit CheckedRobot(const std::string& faults, std::uint32_t seed = 1)
      : world_(world::read_floor_plan(files::TomlReader::load(
                   files::bundled_file("living_room", "hil_mock/worlds", "room"))),
               robot_,
               seed,
               world::parse_part_faults(faults)),
        geometry_(tests::assumed_geometry(robot_)),
        check_(geometry_, {}),
        offline_(world_, geometry_, check_) {}

  const std::optional<Diagnosis>& tour() {
    stop();
    for (const double turn_rad : {0.5, 2.2, 1.6, 2.0}) {
      move(Turn{turn_rad});
      move(Drive{0.6});
      stop();
    }
    return check_.diagnosis();
  }

  void stop() {
    const Sweep sweep{-std::numbers::pi / 2.0, std::numbers::pi / 2.0, 0.07, 0.03};
    check_.begin_scan();
    move(sweep);
    move(Turn{std::numbers::pi});
    move(sweep);
    check_.end_scan();
  }

  SelfCheck& check() { return check_; }

 private:
  void move(const Motion& motion) {
    check_.begin_motion(motion);
    check_.end_motion(offline_.execute(motion));
  }

  world::RobotParams robot_;
  world::RobotWorld world_;
  sensors::RobotGeometry geometry_;
  SelfCheck check_;
  tests::OfflineRobot offline_;
};

TEST(SelfCheck, AccusesNoSoundRobot) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    EXPECT_FALSE(CheckedRobot("", seed).tour()) << seed;
  }
}

TEST(SelfCheck, NamesAReversedPan) {
  CheckedRobot robot("pan-reversed@0");
  const auto& found = robot.tour();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault.kind, FaultKind::kPanReversed);
  EXPECT_LE(found->stops, 3U);
  EXPECT_GT(found->log_odds, SelfCheckParams().min_log_odds);
}

TEST(SelfCheck, NamesAWheelOfAnotherSize) {
  CheckedRobot robot("wheel-right@0:inf:1.08");
  const auto& found = robot.tour();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault.kind, FaultKind::kRightWheelSize);
  EXPECT_NEAR(found->fault.value, 1.08, 0.03);
}

TEST(SelfCheck, LooksNoMoreAfterARobotWasLifted) {
  CheckedRobot robot("pan-reversed@0");
  sensors::HazardObservation lifted;
  lifted.lifted = true;
  robot.check().on_hazards(lifted);
  EXPECT_FALSE(robot.tour());
}

TEST(SelfCheck, IsNotSureBetweenTwoFaultsThatExplainAlike) {
  const std::vector<Explanation> alike{{{FaultKind::kPanOffset, 0.12}, 30.0},
                                       {{FaultKind::kRangeScale, 0.9}, 29.5},
                                       {{FaultKind::kNone, 0.0}, 10.0}};
  EXPECT_FALSE(diagnosis_of(alike));
  const auto found = diagnosis_of({alike[0], alike[2]});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault.kind, FaultKind::kPanOffset);
  EXPECT_EQ(found->log_odds, 20.0);
}

TEST(SelfCheck, HasToBeSurerOfTheSizeOfWheelsThanOfOther) {
  const auto found = [](FaultKind kind, double log_odds) {
    return diagnosis_of({{{kind, 1.08}, log_odds}, {{FaultKind::kNone, 0.0}, 0.0}}).has_value();
  };
  EXPECT_TRUE(found(FaultKind::kRangeScale, 6.0));
  EXPECT_FALSE(found(FaultKind::kWheelSize, 6.0));
  EXPECT_TRUE(found(FaultKind::kWheelSize, 8.0));
  for (const FaultKind one : {FaultKind::kLeftWheelSize, FaultKind::kRightWheelSize}) {
    EXPECT_FALSE(found(one, 8.0));
    EXPECT_TRUE(found(one, 9.0));
  }
}

TEST(SelfCheck, DoesNotCallASmallErrorAFault) {
  const auto found = [](const Fault& fault) {
    return diagnosis_of({{fault, 30.0}, {{FaultKind::kNone, 0.0}, 10.0}}).has_value();
  };
  EXPECT_FALSE(found({FaultKind::kWheelSize, 1.03}));
  EXPECT_TRUE(found({FaultKind::kWheelSize, 1.06}));
  EXPECT_FALSE(found({FaultKind::kRangeScale, 0.94}));
  EXPECT_TRUE(found({FaultKind::kRangeScale, 0.91}));
}

}  // namespace
}  // namespace echomap::diagnosis
