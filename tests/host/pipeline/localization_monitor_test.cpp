// SPDX-License-Identifier: MIT
#include "host/pipeline/localization_monitor.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/localization/heard_scan.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::pipeline {
namespace {

using geometry::Pose2;
using localization::CheckedBelief;
using localization::LocalizationStatus;
using localization::LocalizerOutcome;
using localization::PoseBelief;

const mapping::RasterMap kMonitoredRoom = tests::furnished_room();
const Pose2 kTruePlace(2.2, 0.95, -0.3);
const Pose2 kWrongPlace(0.5, 0.4, 2.0);
/// Walls are near there: heard from it, they are where the floor about kTruePlace is.
const Pose2 kNook(3.0, 0.2, 0.0);

PoseBelief sure_of(const Pose2& T_map_robot) {
  PoseBelief belief;
  belief.status = LocalizationStatus::kLocalized;
  belief.lost_probability = 0.0;
  belief.hypotheses = {{T_map_robot, 0.01 * Eigen::Matrix3d::Identity(), 1.0}};
  return belief;
}

/// A robot, and a filter that is sure of a place, to which the wheels have led it.
class LocalizationMonitorTest : public ::testing::Test {
 protected:
  CheckedBelief check(LocalizationMonitor& monitor,
                      const Pose2& T_map_believed,
                      const Pose2& T_map_robot = kTruePlace) const {
    return monitor.check(sure_of(T_map_believed),
                         {T_map_believed, tests::heard_scan(kMonitoredRoom, T_map_robot), {}});
  }
  LocalizationMonitor comparing(const LocalizationMonitorParams& params = {}) const {
    return {kMonitoredRoom, model_.get(), tests::kEarRangeM, params};
  }
  static LocalizationMonitor not_comparing(const LocalizationMonitorParams& params = {}) {
    return {kMonitoredRoom, nullptr, tests::kEarRangeM, params};
  }

 private:
  const std::unique_ptr<localization::ObservationModel> model_ = tests::sonar_model(kMonitoredRoom);
};

TEST_F(LocalizationMonitorTest, TakesBackAPlaceThatTheNewestScanContradicts) {
  LocalizationMonitor monitor = not_comparing();
  EXPECT_EQ(check(monitor, kTruePlace).belief.status, LocalizationStatus::kLocalized);
  EXPECT_EQ(check(monitor, kTruePlace, kNook).belief.status, LocalizationStatus::kRecovering);
  PoseBelief belief = sure_of(kTruePlace);
  monitor.limit_confidence(belief, kNook);
  EXPECT_EQ(belief.status, LocalizationStatus::kRecovering) << "until the next scan";
}

TEST_F(LocalizationMonitorTest, NeedsEnoughEchoesForAContradiction) {
  LocalizationMonitorParams params;
  params.contradicting_echoes = 1000;
  LocalizationMonitor monitor = not_comparing(params);
  EXPECT_EQ(check(monitor, kTruePlace, kNook).belief.status, LocalizationStatus::kLocalized);
}

TEST_F(LocalizationMonitorTest, NamesNoOtherPlaceWhereItComparesNone) {
  LocalizationMonitor monitor = not_comparing();
  const CheckedBelief checked = check(monitor, kWrongPlace);
  EXPECT_FALSE(checked.T_map_restart);
  EXPECT_EQ(checked.belief.lost_probability, 0.0);
}

TEST_F(LocalizationMonitorTest, FindsThePlaceOfARobotThatMayBeAnywhere) {
  LocalizationMonitor monitor = comparing();
  const CheckedBelief checked = check(monitor, kWrongPlace);
  ASSERT_TRUE(checked.T_map_restart);
  EXPECT_LT((checked.T_map_restart->position_m() - kTruePlace.position_m()).norm(), 0.2);
}

/// A place beside the true one, from which no other is so much better that it is given up for it,
/// while echoes come from its floor.
const Pose2 kBesideTruePlace(2.0, 0.65, -0.3);

LocalizationMonitorParams strict() {
  LocalizationMonitorParams params;
  params.contradicting_echoes = 1;
  params.contradicting_floor_share = 0.0;
  return params;
}

TEST_F(LocalizationMonitorTest, ComparesAllPlacesAfterContradictionsInARow) {
  LocalizationMonitor monitor = comparing(strict());
  monitor.start_at(LocalizerOutcome::kMoved);
  EXPECT_FALSE(check(monitor, kBesideTruePlace).T_map_restart) << "one scan may err";
  EXPECT_TRUE(check(monitor, kBesideTruePlace).T_map_restart);
}

TEST_F(LocalizationMonitorTest, CountsContradictionsAgainAfterAScanThatFits) {
  LocalizationMonitor monitor = comparing(strict());
  monitor.start_at(LocalizerOutcome::kMoved);
  check(monitor, kBesideTruePlace);
  check(monitor, kTruePlace);
  EXPECT_FALSE(check(monitor, kBesideTruePlace).T_map_restart);
  EXPECT_TRUE(check(monitor, kBesideTruePlace).T_map_restart);
}

TEST_F(LocalizationMonitorTest, IsNoSurerBetweenScansThanAtTheLastOne) {
  LocalizationMonitor monitor = comparing();
  const CheckedBelief checked = check(monitor, kWrongPlace);
  ASSERT_NE(checked.belief.status, LocalizationStatus::kLocalized);
  ASSERT_GT(checked.belief.lost_probability, 0.0);
  PoseBelief belief = sure_of(kTruePlace);
  monitor.limit_confidence(belief, kTruePlace);
  EXPECT_EQ(belief.status, LocalizationStatus::kRecovering);
  EXPECT_EQ(belief.lost_probability, checked.belief.lost_probability);
}

TEST_F(LocalizationMonitorTest, KeepsThePlacesThatFitUntilTheNextScan) {
  LocalizationMonitor monitor = comparing();
  const auto places = check(monitor, kWrongPlace).belief.hypotheses;
  PoseBelief belief = sure_of(kTruePlace);
  const Pose2 way(0.2, 0.1, 0.3);
  monitor.limit_confidence(belief, kWrongPlace * way);
  ASSERT_EQ(belief.hypotheses.size(), places.size());
  const Pose2 off = (places[0].T_map_robot * way).inverse() * belief.hypotheses[0].T_map_robot;
  EXPECT_LT(off.position_m().norm(), 1e-9);
}

TEST_F(LocalizationMonitorTest, ForgetsItsDoubtWhereSomebodyTellsAPlace) {
  LocalizationMonitor monitor = comparing();
  check(monitor, kWrongPlace);
  monitor.start_at(LocalizerOutcome::kMoved);
  PoseBelief belief = sure_of(kTruePlace);
  monitor.limit_confidence(belief, kTruePlace);
  EXPECT_EQ(belief.status, LocalizationStatus::kLocalized);
  EXPECT_EQ(check(monitor, kTruePlace).belief.status, LocalizationStatus::kLocalized);
}

TEST_F(LocalizationMonitorTest, ComparesAllPlacesOfARobotThatIsToldToBeOffTheFloor) {
  LocalizationMonitor monitor = comparing();
  monitor.start_at(LocalizerOutcome::kMoved);
  monitor.start_at(LocalizerOutcome::kOffTheFloor);
  EXPECT_TRUE(check(monitor, kWrongPlace).T_map_restart);
}

TEST_F(LocalizationMonitorTest, TellsWhereTwoPlacesLookDifferent) {
  const std::vector<localization::PoseHypothesis> two{
      {kTruePlace, Eigen::Matrix3d::Identity(), 0.5},
      {kWrongPlace, Eigen::Matrix3d::Identity(), 0.5}};
  EXPECT_EQ(not_comparing().telling(two, Pose2()), 0.0);
  EXPECT_GT(comparing().telling(two, Pose2()), 0.0);
}

TEST_F(LocalizationMonitorTest, RejectsInvalidParameters) {
  LocalizationMonitorParams params;
  params.contradicting_floor_share = 1.5;
  EXPECT_THROW(not_comparing(params), std::invalid_argument);
  params = {};
  params.contradictions_of_lost = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
