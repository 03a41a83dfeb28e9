// SPDX-License-Identifier: MIT
#include "host/localization/place_check.hpp"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/host/localization/heard_scan.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

PoseBelief belief_at(const Pose2& T_map_robot) {
  PoseBelief belief;
  belief.status = LocalizationStatus::kLocalized;
  belief.lost_probability = 0.0;
  belief.hypotheses = {{T_map_robot, 0.01 * Eigen::Matrix3d::Identity(), 1.0}};
  return belief;
}

/// A robot that truly stands at one place of the room while a filter believes in another.
struct Checked {
  explicit Checked(const mapping::RasterMap& map)
      : room(map), model(tests::sonar_model(map)), check(*model) {}

  CheckedBelief scan(const Pose2& T_map_robot, const Pose2& T_map_believed) {
    return check.check(belief_at(T_map_believed),
                       {T_odom_map * T_map_robot, tests::heard_scan(room, T_map_robot), {}},
                       [&](const Pose2& /*T_map_robot*/) { return is_contradicted; });
  }

  mapping::RasterMap room;
  std::unique_ptr<ObservationModel> model;
  PlaceCheck check;
  Pose2 T_odom_map{-1.5, 0.7, 1.1};
  bool is_contradicted = false;
};

const Pose2 kHere(2.2, 0.95, -0.3);
const Pose2 kThere(0.5, 0.4, 2.0);

TEST(PlaceCheck, ClaimsThePlaceThatNoOtherComesNear) {
  Checked robot(tests::furnished_room());
  CheckedBelief checked = robot.scan({1.5, 0.95, 0.4}, {1.5, 0.95, 0.4});
  checked = robot.scan({1.9, 1.05, 0.0}, {1.9, 1.05, 0.0});
  checked = robot.scan(kHere, kHere);
  EXPECT_TRUE(robot.check.is_known());
  EXPECT_EQ(checked.belief.status, LocalizationStatus::kLocalized);
  EXPECT_LE(checked.belief.lost_probability, 0.05);
  EXPECT_FALSE(checked.T_map_restart) << "the filter is there";
}

TEST(PlaceCheck, TellsAFilterThatFollowsAnotherPlaceToStartAgain) {
  Checked robot(tests::furnished_room());
  const CheckedBelief checked = robot.scan(kHere, kThere);
  ASSERT_TRUE(checked.T_map_restart);
  EXPECT_LT((checked.T_map_restart->position_m() - kHere.position_m()).norm(), 0.2);
}

TEST(PlaceCheck, KeepsAPlaceThatItWasTold) {
  Checked robot(tests::furnished_room());
  robot.check.begin_known();
  for (int i = 0; i < 4; ++i) {
    const Pose2 T_map_robot(1.4 + 0.2 * i, 1.0, 0.0);
    EXPECT_EQ(robot.scan(T_map_robot, T_map_robot).belief.status, LocalizationStatus::kLocalized)
        << i;
  }
}

TEST(PlaceCheck, GivesUpAPlaceThatAnotherOutweighs) {
  Checked robot(tests::furnished_room());
  robot.check.begin_known();
  bool is_lost = false;
  for (int i = 0; i < 4 && !is_lost; ++i) {
    const CheckedBelief checked =
        robot.scan({1.4 + 0.15 * i, 1.0, 0.0}, {0.4 + 0.15 * i, 0.45, 0.0});
    is_lost =
        checked.belief.status == LocalizationStatus::kLost ||
        (checked.belief.status == LocalizationStatus::kLocalized &&
         (checked.belief.hypotheses.front().T_map_robot.position_m() - kHere.position_m()).norm() <
             0.2);
    EXPECT_TRUE(is_lost || checked.belief.lost_probability > 0.05) << i;
  }
  EXPECT_TRUE(is_lost);
}

TEST(PlaceCheck, TrustsAKnownPlaceLessWhereTheFilterDidNotGoWhereTheWheelsWent) {
  const auto lost_probability_after = [](double departed_rad) {
    Checked robot(tests::furnished_room());
    robot.check.begin_known();
    const Pose2 T_map_before(1.5, 0.95, 0.0);
    robot.scan(T_map_before, T_map_before);
    const Pose2 T_map_robot(2.0, 0.95, 0.0);
    const PoseBelief belief =
        robot.scan(T_map_robot, T_map_robot * Pose2(0.0, 0.0, departed_rad)).belief;
    return belief.lost_probability;
  };
  EXPECT_NEAR(lost_probability_after(0.05), lost_probability_after(0.0), 0.01);
  EXPECT_GT(lost_probability_after(0.25), lost_probability_after(0.0) + 0.1);
}

TEST(PlaceCheck, TellsWhichPlacesFitWhileAKnownOneIsDoubted) {
  int doubted = 0;
  for (const double off_m : {0.6, 0.7, 0.8, 0.9, 1.0}) {
    Checked robot(tests::furnished_room());
    robot.check.begin_known();
    const PoseBelief told = robot.scan(kHere, {kHere.x_m() - off_m, 0.95, -0.3}).belief;
    if (told.status == LocalizationStatus::kRecovering) {
      ++doubted;
      ASSERT_GE(told.hypotheses.size(), 2U) << off_m;
      EXPECT_GE(told.hypotheses[0].probability, told.hypotheses[1].probability);
      EXPECT_GE(told.lost_probability, 1.0 - told.hypotheses[0].probability - 1e-9);
    }
  }
  EXPECT_GT(doubted, 0);
}

TEST(PlaceCheck, NeverClaimsAnEndOfARoomThatHasTwoAlike) {
  tests::DrawnMap drawing(14, "#" + std::string(30, '.') + "#");
  drawing.front() = drawing.back() = std::string(32, '#');
  Checked robot(tests::map_from(drawing, 0.1));
  for (int i = 0; i < 6; ++i) {
    const Pose2 T_map_robot(0.7 + 0.3 * i, 0.6 + 0.05 * i, 0.2 * i);
    const CheckedBelief checked = robot.scan(T_map_robot, T_map_robot);
    EXPECT_NE(checked.belief.status, LocalizationStatus::kLocalized) << i;
    EXPECT_GE(checked.belief.hypotheses.size(), 2U) << i;
  }
}

TEST(PlaceCheck, TellsThatAPlaceIsLostOnceWhenItIsDoubted) {
  Checked robot(tests::furnished_room());
  robot.check.begin_known();
  robot.scan({1.5, 0.95, 0.4}, {1.5, 0.95, 0.4});
  robot.check.doubt();
  EXPECT_FALSE(robot.check.is_known());
  EXPECT_EQ(robot.scan(kHere, kThere).belief.status, LocalizationStatus::kLost);
  EXPECT_NE(robot.scan({1.9, 1.05, 0.0}, {1.9, 1.05, 0.0}).belief.status,
            LocalizationStatus::kLost);
}

TEST(PlaceCheck, ClaimsNoPlaceThatTheNewestScanContradicts) {
  Checked robot(tests::furnished_room());
  robot.is_contradicted = true;
  for (const Pose2& T_map_robot : {Pose2(1.5, 0.95, 0.4), Pose2(1.9, 1.05, 0.0), kHere}) {
    EXPECT_NE(robot.scan(T_map_robot, T_map_robot).belief.status, LocalizationStatus::kLocalized);
  }
  EXPECT_FALSE(robot.check.is_known());
}

TEST(PlaceCheck, LeavesABeliefAloneWithoutAReading) {
  Checked robot(tests::furnished_room());
  const auto checked = robot.check.check(
      belief_at(kHere), {kHere, {}, {}}, [](const Pose2& /*T_map_robot*/) { return false; });
  EXPECT_EQ(checked.belief.status, LocalizationStatus::kLocalized);
  EXPECT_FALSE(checked.T_map_restart);
}

TEST(PlaceCheck, BeginsAgainWithTheScanAtWhichTheFilterGaveUp) {
  Checked robot(tests::furnished_room());
  robot.check.begin_known();
  PoseBelief lost = belief_at(kHere);
  lost.status = LocalizationStatus::kLost;
  const Pose2 T_map_middle(3.3, 0.95, 0.0);
  const CheckedBelief checked =
      robot.check.check(lost,
                        {T_map_middle, tests::heard_scan(robot.room, T_map_middle), {}},
                        [](const Pose2& /*T_map_robot*/) { return false; });
  EXPECT_EQ(checked.belief.status, LocalizationStatus::kLost);
  ASSERT_TRUE(checked.T_map_restart) << "it was known, and is not any more";
  EXPECT_LT((checked.T_map_restart->position_m() - T_map_middle.position_m()).norm(), 0.2);
}

}  // namespace
}  // namespace echomap::localization
