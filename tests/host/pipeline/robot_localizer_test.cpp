// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_localizer.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/ray_casting.hpp"
#include "tests/host/pipeline/plain_robot.hpp"
#include "tests/support/expect_pose_estimate.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::pipeline {
namespace {

using geometry::Pose2;
using localization::LocalizationStatus;

const mapping::RasterMap kRoom = tests::furnished_room();

RobotLocalizerParams params() {
  RobotLocalizerParams params;
  params.sensor.emplace().beam_half_angle_rad = geometry::radians(13.0);
  params.sensor->max_range_m = 3.0;
  return params;
}

/// A robot in the room of which the test tells the story, and what it hears: what the map says.
class RobotLocalizerTest : public ::testing::Test {
 protected:
  void turn(double turn_rad) {
    left_m -= 0.1 * turn_rad;
    right_m += 0.1 * turn_rad;
    T_map_robot = T_map_robot * Pose2(0.0, 0.0, turn_rad);
    localizer.on_odometry({now(), {left_m, right_m}});
  }
  void drive(double distance_m) {
    left_m += distance_m;
    right_m += distance_m;
    T_map_robot = T_map_robot * Pose2(distance_m, 0.0, 0.0);
    localizer.on_odometry({now(), {left_m, right_m}});
  }
  /// As that, and looks around on the way.
  void drive_listening(double distance_m) {
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
      drive(distance_m / kSteps);
      for (int pan_deg = -90; pan_deg <= 90; pan_deg += 45) {
        ping(geometry::radians(pan_deg));
      }
    }
  }
  /// All around, in two halves between which the body turns.
  void scan() {
    localizer.begin_scan();
    for (int half = 0; half < 2; ++half) {
      for (int pan_deg = -90; pan_deg < 90; pan_deg += 6) {
        ping(geometry::radians(pan_deg));
      }
      turn(std::numbers::pi);
    }
    localizer.end_scan();
  }
  void stop_at_three_places() {
    for (const double turn_rad : {0.3, -0.5, 0.7}) {
      scan();
      turn(turn_rad);
      drive_listening(0.3);
    }
    scan();
  }
  void lift(bool lifted) {
    sensors::HazardObservation hazards;
    hazards.stamp = now();
    hazards.lifted = lifted;
    localizer.on_hazards(hazards);
  }
  time::RobotTime now() {
    stamp_us_ += 20'000;
    return time::RobotTime(time::RobotClock::duration(stamp_us_));
  }

  Pose2 T_map_robot{0.45, 0.95, 0.1};
  RobotLocalizer localizer{kRoom, plain_robot(), params(), std::mt19937(1)};
  double left_m = 0.0;
  double right_m = 0.0;

  /// Hears the nearest thing in the cone.
  void ping(double pan_rad) {
    const Pose2 T_map_sonar = T_map_robot * Pose2(0.0, 0.0, pan_rad);
    float nearest_m = 3.0F;
    for (int aside_deg = -12; aside_deg <= 12; aside_deg += 3) {
      const Eigen::Vector2f direction =
          geometry::unit_vector(T_map_sonar.heading_rad() + geometry::radians(aside_deg))
              .cast<float>();
      float range_m = 0.0F;
      mapping::cast_rays(field_, T_map_sonar.position_m(), {&direction, 1}, 3.0, {&range_m, 1});
      nearest_m = std::min(nearest_m, range_m);
    }
    const bool is_heard = nearest_m < 3.0F;
    localizer.on_sonar({now(),
                        {left_m, right_m},
                        pan_rad,
                        is_heard ? std::optional<double>(nearest_m) : std::nullopt});
  }

 private:
  mapping::DistanceField field_{kRoom, 3.0};
  std::int64_t stamp_us_ = 0;
};

TEST_F(RobotLocalizerTest, FindsARobotThatMayBeAnywhere) {
  stop_at_three_places();
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.15, 0.15));
  EXPECT_EQ(localizer.belief().status, LocalizationStatus::kLocalized);
  EXPECT_EQ(localizer.scans(), 4U);
  EXPECT_EQ(localizer.trajectory().size(), 4U);
}

TEST_F(RobotLocalizerTest, ShowsWhereItsParticlesLie) {
  EXPECT_TRUE(localizer.sampled_poses(10).empty());
  scan();
  const std::size_t shown = localizer.sampled_poses(10).size();
  EXPECT_GE(shown, 5U);
  EXPECT_LE(shown, 10U);
}

TEST_F(RobotLocalizerTest, FollowsARobotFromWhereItIsTold) {
  turn(0.0);
  localizer.start_at(T_map_robot, 0.05, 0.05);
  EXPECT_EQ(localizer.belief().status, LocalizationStatus::kLocalized);
  drive(0.5);
  scan();
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.1, 0.1));
}

TEST_F(RobotLocalizerTest, BeginsWhereItIsToldHoweverFarTheWheelsHaveRolledBefore) {
  localizer.start_at(T_map_robot, 0.05, 0.05);
  left_m = 7.0;
  right_m = 5.5;
  scan();
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.1, 0.1));
  EXPECT_EQ(localizer.belief().status, LocalizationStatus::kLocalized);
}

TEST_F(RobotLocalizerTest, BeginsWhereItIsToldAlthoughABumperIsPressed) {
  localizer.start_at(T_map_robot, 0.05, 0.05);
  sensors::HazardObservation hazards;
  hazards.bump_left = true;
  localizer.on_hazards(hazards);
  turn(0.0);
  EXPECT_EQ(localizer.belief().status, LocalizationStatus::kLocalized);
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.1, 0.1));
}

TEST_F(RobotLocalizerTest, HearsNothingInTheAir) {
  stop_at_three_places();
  localizer.begin_scan();
  lift(true);
  scan();
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
}

TEST_F(RobotLocalizerTest, TellsThatItCannotBeWhereItIsToldToBegin) {
  localizer.start_at(Pose2(50.0, 50.0, 0.0), 0.05, 0.05);
  EXPECT_EQ(localizer.start_outcome(), localization::LocalizerOutcome::kMoved) << "not yet";
  turn(0.0);
  EXPECT_EQ(localizer.start_outcome(), localization::LocalizerOutcome::kOffTheFloor);
  localizer.start_at(T_map_robot, 0.05, 0.05);
  EXPECT_EQ(localizer.start_outcome(), localization::LocalizerOutcome::kMoved);
}

TEST_F(RobotLocalizerTest, GrowsUnsureByATurnToAndFro) {
  turn(0.0);
  localizer.start_at(T_map_robot, 0.05, 0.05);
  const double before = localizer.belief().hypotheses.front().covariance(2, 2);
  for (int i = 0; i < 10; ++i) {
    turn(1.5);
    turn(-1.5);
  }
  EXPECT_GT(localizer.belief().hypotheses.front().covariance(2, 2), 1.5 * before);
}

TEST_F(RobotLocalizerTest, MayBeAnywhereOnceItWasLifted) {
  stop_at_three_places();
  localizer.begin_scan();
  lift(true);
  lift(true);
  EXPECT_EQ(localizer.times_lifted(), 1U);
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
  lift(false);
  T_map_robot = Pose2(3.6, 0.6, 2.2);
  stop_at_three_places();
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.15, 0.15));
}

TEST_F(RobotLocalizerTest, MayBeAnywhereOnceItWasCarried) {
  stop_at_three_places();
  localizer.on_carried({now(), {left_m, right_m}, T_map_robot});
  EXPECT_EQ(localizer.times_lifted(), 1U);
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
  T_map_robot = Pose2(3.6, 0.6, 2.2);
  stop_at_three_places();
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.15, 0.15));
}

TEST_F(RobotLocalizerTest, TakesFourCliffsAtOnceForBeingLiftedAndOneForACliff) {
  sensors::HazardObservation hazards;
  hazards.cliffs = {true, true, true, false};
  localizer.on_hazards(hazards);
  EXPECT_EQ(localizer.times_lifted(), 0U);
  hazards.cliffs.fill(true);
  localizer.on_hazards(hazards);
  EXPECT_EQ(localizer.times_lifted(), 1U);
}

TEST_F(RobotLocalizerTest, TakesReadingsOfScansOnly) {
  localizer.on_sonar({now(), {}, 0.0, 1.0});
  localizer.end_scan();
  EXPECT_EQ(localizer.scans(), 0U);
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
}

/// Robots that go the same way, and listen on it or not.
class Wayfarer : public RobotLocalizerTest {
 public:
  double lost_probability_after_two_stops(bool listens) {
    scan();
    turn(0.3);
    listens ? drive_listening(0.6) : drive(0.6);
    scan();
    EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), T_map_robot, 0.15, 0.15));
    return localizer.belief().lost_probability;
  }

 private:
  void TestBody() override {}
};

TEST(RobotLocalizer, LearnsFromWhatItHearsOnItsWay) {
  const double deaf = Wayfarer().lost_probability_after_two_stops(false);
  const double listening = Wayfarer().lost_probability_after_two_stops(true);
  EXPECT_LT(listening, 0.9 * deaf);
}

/// Robots that are carried off from a known place without noticing it.
class CarriedOff : public RobotLocalizerTest {
 public:
  CarriedOff() {
    T_map_start = T_map_robot;
    turn(0.0);
    localizer.start_at(T_map_robot, 0.05, 0.05);
    scan();
  }
  Pose2 T_map_start;
  LocalizationStatus status_at(const Pose2& T_map_elsewhere) {
    T_map_robot = T_map_elsewhere;
    scan();
    return localizer.belief().status;
  }
  LocalizationStatus status_after_a_drive() {
    drive(0.3);
    return localizer.belief().status;
  }

 private:
  void TestBody() override {}
};

TEST(RobotLocalizer, DoesNotClaimADoubtedPlaceAgainBecauseTheWheelsRoll) {
  int doubted = 0;
  for (const double x_m : {0.5, 0.7, 0.9, 2.4, 2.7, 3.3, 3.5}) {
    for (const double heading_rad : {0.1, 0.5, 3.1}) {
      CarriedOff robot;
      if (robot.status_at({x_m, 1.05, heading_rad}) == LocalizationStatus::kRecovering) {
        ++doubted;
        EXPECT_NE(robot.status_after_a_drive(), LocalizationStatus::kLocalized) << x_m;
      }
    }
  }
  EXPECT_GT(doubted, 0);
}

TEST(RobotLocalizer, ClaimsADoubtedPlaceAgainWhereItsScansFit) {
  int doubted = 0;
  for (const double x_m : {0.5, 0.7, 0.9, 2.4, 2.7, 3.3, 3.5}) {
    CarriedOff robot;
    if (robot.status_at({x_m, 1.05, 0.1}) == LocalizationStatus::kRecovering) {
      ++doubted;
      EXPECT_EQ(robot.status_at(robot.T_map_start), LocalizationStatus::kLocalized)
          << "a scan from the same spot replaces that from " << x_m;
    }
  }
  EXPECT_GT(doubted, 0);
}

/// One of infra-red sensors and bumpers, in the room.
class FeelingRobotLocalizer : public ::testing::Test {
 protected:
  FeelingRobotLocalizer() {
    params.sensor.emplace().by = localization::LocalizedBy::kInfrared;
    params.sensor->max_range_m = 0.2;
    params.T_robot_infrared = {Pose2(), Pose2(0.0, 0.0, 1.0)};
    params.infrared_step_m = 0.1;
    params.step_m = 0.1;
    params.particles = 321;
  }
  void drive(RobotLocalizer& localizer, double to_m) const {
    for (double travelled_m = 0.0; travelled_m < to_m; travelled_m += 0.01) {
      localizer.on_odometry({{}, {travelled_m, travelled_m}});
      localizer.on_infrared({{}, {travelled_m, travelled_m}, {0.1, std::nullopt}});
    }
  }
  RobotLocalizer localizer() const {
    return RobotLocalizer(kRoom, plain_robot(), params, std::mt19937(1));
  }

  RobotLocalizerParams params;
};

TEST_F(FeelingRobotLocalizer, CountsARoundOfInfraredAStepHoweverOftenTheWheelsTell) {
  RobotLocalizer robot = localizer();
  drive(robot, 0.955);
  EXPECT_EQ(robot.scans(), 10U);
  EXPECT_EQ(robot.trajectory().size(), 10U);
}

/// On free floor, while its sensors see a wall.
TEST_F(FeelingRobotLocalizer, DoesNotClaimAPlaceThatItsRoundsContradict) {
  for (const bool sees_walls : {false, true}) {
    RobotLocalizer robot = localizer();
    robot.start_at({1.2, 1.2, 0.0}, 0.01, 0.01);
    for (double travelled_m = 0.0; travelled_m < 0.5; travelled_m += 0.01) {
      const auto range_m = sees_walls ? std::optional(0.1) : std::nullopt;
      robot.on_infrared({{}, {travelled_m, travelled_m}, {range_m, range_m}});
    }
    EXPECT_EQ(robot.belief().status == LocalizationStatus::kLocalized, !sees_walls);
  }
}

TEST_F(FeelingRobotLocalizer, LeavesOutARoundOfAnotherRing) {
  RobotLocalizer robot = localizer();
  robot.on_infrared({{}, {}, {0.1}});
  EXPECT_EQ(robot.scans(), 0U);
}

TEST_F(FeelingRobotLocalizer, HasAsManyParticlesAsAreAskedFor) {
  RobotLocalizer robot = localizer();
  drive(robot, 0.05);
  EXPECT_EQ(robot.sampled_poses(100'000).size(), 321U);
}

TEST_F(FeelingRobotLocalizer, CountsEachContactWhereItBegins) {
  params.sensor->by = localization::LocalizedBy::kContacts;
  RobotLocalizer robot = localizer();
  drive(robot, 0.05);
  const auto feel = [&](bool left, bool right, bool light) {
    sensors::HazardObservation hazards;
    hazards.bump_left = left;
    hazards.bump_right = right;
    hazards.virtual_wall = light;
    robot.on_hazards(hazards);
    return robot.scans();
  };
  EXPECT_EQ(feel(false, false, true), 1U);
  EXPECT_EQ(feel(false, false, true), 1U) << "the same wall";
  EXPECT_EQ(feel(true, false, true), 2U) << "a bump, while the light is seen";
  EXPECT_EQ(feel(false, false, false), 2U);
  EXPECT_EQ(feel(true, true, false), 3U);
}

TEST(RobotLocalizer, RejectsInvalidParameters) {
  auto bad = params();
  bad.max_readings = 0;
  EXPECT_THROW(RobotLocalizer(kRoom, plain_robot(), bad, std::mt19937(1)), std::invalid_argument);
  bad = params();
  bad.step_rad = 0.0;
  EXPECT_THROW(RobotLocalizer(kRoom, plain_robot(), bad, std::mt19937(1)), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
