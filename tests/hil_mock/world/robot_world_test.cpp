// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_world.hpp"

#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/exact_robot.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

struct Trace {
  std::vector<double> values;
  bool operator==(const Trace&) const = default;
};

Trace drive_and_ping(std::uint32_t seed, int extra_pings) {
  RobotWorld world(box_room(), RobotParams{}, seed);
  EncoderChanges changes;
  Trace trace;
  for (int i = 0; i < 300; ++i) {
    world.step(0.001, {0.5, 0.7}, changes);
    if (i % 50 == 0) {
      for (int k = 0; k < 1 + extra_pings; ++k) {
        world.ping(0.1 * k);
      }
    }
  }
  trace.values = {world.T_world_robot().x_m(),
                  world.T_world_robot().y_m(),
                  world.T_world_robot().heading_rad()};
  return trace;
}

TEST(RobotWorld, KnowsPlacesElsewhereWithRoomForTheRobot) {
  RobotWorld world(box_room(), RobotParams{}, 5);
  for (int i = 0; i < 20; ++i) {
    const geometry::Pose2 before = world.T_world_robot();
    const geometry::Pose2 place = world.somewhere_else();
    EXPECT_TRUE(world.fits(place.position_m(), 0.05)) << i;
    EXPECT_GT((place.position_m() - before.position_m()).norm(), 1.0) << i;
    world.place(place);
  }
  RobotWorld twin(box_room(), RobotParams{}, 5);
  RobotWorld other(box_room(), RobotParams{}, 6);
  const geometry::Pose2 first = RobotWorld(box_room(), RobotParams{}, 5).somewhere_else();
  EXPECT_EQ(twin.somewhere_else().position_m(), first.position_m());
  EXPECT_NE(other.somewhere_else().position_m(), first.position_m());
}

TEST(RobotWorld, IsAFunctionOfItsSeed) {
  EXPECT_EQ(drive_and_ping(3, 0), drive_and_ping(3, 0));
  EXPECT_FALSE(drive_and_ping(3, 0) == drive_and_ping(4, 0));
}

TEST(RobotWorld, PingsDoNotChangeHowTheBodyMoves) {
  EXPECT_EQ(drive_and_ping(3, 0), drive_and_ping(3, 5));
}

TEST(RobotWorld, FlightTimeIsThereAndBackFromTheMount) {
  RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  RobotWorld world(box_room(), robot, 1);
  const double ahead_m = 4.0 - 2.0 - 0.03;
  EXPECT_NEAR(world.ping(0.0).value(), 2.0 * ahead_m / 343.2, 1e-9);
  EXPECT_NEAR(world.ping(0.5 * std::numbers::pi).value(), 2.0 * 1.5 / 343.2, 1e-9);
}

TEST(RobotWorld, HearsABoxFromWhenItStandsThereAndBumpsIntoIt) {
  RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  RobotWorld world(box_room(), robot, 1);
  world.put_box(rectangle(2.5, 1.3, 2.9, 1.7));
  EXPECT_NEAR(world.ping(0.0).value(), 2.0 * 0.47 / 343.2, 1e-9);
  EncoderChanges changes;
  const auto touches = [&] { return world.contacts().left || world.contacts().right; };
  for (int i = 0; i < 4000 && !touches(); ++i) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  EXPECT_TRUE(touches());
  EXPECT_NEAR(world.T_world_robot().x_m(), 2.5 - robot.body.radius_m, 0.01);
}

TEST(RobotWorld, IsClearOfABoxAHandAwayFromItsHull) {
  const RobotWorld world(box_room(), RobotParams{}, 1);
  const Polygon box_m = rectangle(2.0, 1.0, 3.0, 2.0);
  const double radius_m = world.robot().body.radius_m;
  EXPECT_FALSE(world.is_clear_of(box_m, {2.5, 1.5})) << "in its middle";
  EXPECT_FALSE(world.is_clear_of(box_m, {2.0 - radius_m - 0.07, 1.5}));
  EXPECT_TRUE(world.is_clear_of(box_m, {2.0 - radius_m - 0.09, 1.5}));
}

TEST(RobotWorld, KnowsWhereTheRobotIsSeenFromItsStart) {
  RobotWorld world(box_room({}, {2.0, 1.5, 0.5 * std::numbers::pi}), RobotParams{}, 1);
  world.place({2.0, 2.0, std::numbers::pi});
  EXPECT_NEAR(world.T_start_robot().x_m(), 0.5, 1e-12);
  EXPECT_NEAR(world.T_start_robot().y_m(), 0.0, 1e-12);
  EXPECT_NEAR(world.T_start_robot().heading_rad(), 0.5 * std::numbers::pi, 1e-12);
}

TEST(RobotWorld, CanBePutElsewhere) {
  RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  RobotWorld world(box_room(), robot, 1);
  world.place({1.0, 1.0, std::numbers::pi});
  EXPECT_NEAR(world.ping(0.0).value(), 2.0 * 0.97 / 343.2, 1e-9);
}

/// All that a robot can carry, at work; what it does to body and sonar shows in the trace.
TEST(RobotWorld, PartsDoNotChangeHowTheBodyMovesAndWhatTheSonarHears) {
  const auto trace = [](const RobotParams& robot) {
    RobotWorld world(box_room(), robot, 5);
    EncoderChanges changes;
    std::vector<double> values;
    for (int i = 0; i < 300; ++i) {
      world.step(0.001, {0.5, 0.7}, changes);
      world.parts().millivolts(PinPart::kBattery);
      values.push_back(world.T_world_robot().heading_rad());
      values.push_back(world.ping(0.001 * i).value_or(0.0));
    }
    return values;
  };
  RobotParams equipped;
  equipped.parts.ranges = {{0, IrKind::kEpuck, {}}};
  equipped.parts.gyro = GyroParams{};
  equipped.parts.battery = BatteryParams{};
  EXPECT_EQ(trace({}), trace(equipped));
}

TEST(RobotWorld, WithAWheelOverAHoleItIsStuck) {
  const FloorPlan stairs("stairs",
                         {rectangle(0.0, 0.0, 4.0, 3.0), {}},
                         {},
                         {2.0, 1.5, 0.0},
                         {{rectangle(3.0, 0.0, 4.0, 3.0)}, {}});
  RobotWorld world(stairs, {}, 1);
  EncoderChanges changes;
  for (int i = 0; i < 6000; ++i) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  EXPECT_FALSE(world.body().support().left && world.body().support().right);
  const Eigen::Vector2d stuck_m = world.T_world_robot().position_m();
  EXPECT_NEAR(stuck_m.x(), 3.0, 0.07) << "half a track";
  for (int i = 0; i < 1000; ++i) {
    world.step(0.001, {-0.5, -0.5}, changes);
  }
  EXPECT_EQ(world.T_world_robot().position_m(), stuck_m) << "it turns its wheels in the air";
}

TEST(RobotWorld, LiftedItsWheelsTurnAndItStays) {
  RobotWorld world(box_room(), {}, 1);
  world.lift();
  EncoderChanges changes;
  for (int i = 0; i < 500; ++i) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  EXPECT_EQ(world.T_world_robot().x_m(), 2.0);
  EXPECT_GT(world.body().left_wheel().counts(), 500);
  world.place({1.0, 1.0, 0.0});
  world.step(0.001, {0.5, 0.5}, changes);
  EXPECT_GT(world.T_world_robot().x_m(), 1.0);
}

/// Drives for so many seconds, straight ahead as far as the robot knows.
EncoderChanges drive_for(RobotWorld& world, double seconds) {
  EncoderChanges changes;
  for (double at_s = 0.0; at_s < seconds; at_s += 0.001) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  return changes;
}

RobotWorld world_with(const std::string& faults) {
  return {box_room(), RobotParams{}, 1, parse_part_faults(faults)};
}

TEST(RobotWorld, AWheelThatSlipsTurnsTheRobotWhileItsEncoderGoesOn) {
  RobotWorld whole = world_with("");
  RobotWorld slipping = world_with("slip-left@0:1:0.3");
  const auto edges = drive_for(whole, 1.0).left.size();
  EXPECT_EQ(drive_for(slipping, 1.0).left.size(), edges);
  const double turned_rad =
      slipping.T_world_robot().heading_rad() - whole.T_world_robot().heading_rad();
  EXPECT_GT(turned_rad, 0.2);
  EXPECT_LT(turned_rad, 0.6);
}

TEST(RobotWorld, ADeadEncoderIsStillWhileItsWheelTurns) {
  RobotWorld world = world_with("encoder-left@0.5");
  EXPECT_GT(drive_for(world, 0.4).left.size(), 100U);
  drive_for(world, 0.11);
  const EncoderChanges changes = drive_for(world, 0.5);
  EXPECT_TRUE(changes.left.empty());
  EXPECT_GT(changes.right.size(), 100U);
  EXPECT_GT(world.T_world_robot().x_m(), 2.1) << "it drives on";
}

TEST(RobotWorld, ASonarMayDieOrSayOneThing) {
  RobotWorld dead = world_with("sonar-dead@0.1:0.2");
  EXPECT_TRUE(dead.ping(0.0));
  drive_for(dead, 0.2);
  EXPECT_TRUE(dead.sonar_is_dead());
  EXPECT_FALSE(dead.ping(0.0));
  drive_for(dead, 0.2);
  EXPECT_TRUE(dead.ping(0.0)) << "it is back";

  RobotWorld stuck = world_with("sonar-stuck@0:inf:0.7");
  drive_for(stuck, 0.01);
  for (const double pan_rad : {-1.0, 0.3, 1.4}) {
    EXPECT_NEAR(stuck.ping(pan_rad).value_or(0.0), 2.0 * 0.7 / 343.2, 1e-9);
  }
}

/// An edge that comes late comes with the next one: both pins change at once, and two counts are
/// lost.
TEST(RobotWorld, ADirtyEncoderChangesBothPinsAtOnceNowAndThen) {
  const auto illegal_steps = [](const std::vector<LevelChange>& changes) {
    std::size_t steps = 0;
    for (std::size_t i = 1; i < changes.size(); ++i) {
      steps += changes[i].a != changes[i - 1].a && changes[i].b != changes[i - 1].b ? 1U : 0U;
    }
    return steps;
  };
  RobotWorld clean = world_with("");
  RobotWorld dirty = world_with("encoder-left-dirty@0:inf:0.1");
  const EncoderChanges all = drive_for(clean, 1.0);
  const EncoderChanges seen = drive_for(dirty, 1.0);
  EXPECT_EQ(illegal_steps(all.left), 0U);
  EXPECT_EQ(seen.right.size(), all.right.size());
  const auto dropped = static_cast<double>(all.left.size() - seen.left.size());
  EXPECT_NEAR(dropped / static_cast<double>(all.left.size()), 0.1, 0.05);
  EXPECT_NEAR(static_cast<double>(illegal_steps(seen.left)), 0.9 * dropped, 0.15 * dropped);
}

TEST(RobotWorld, ASonarMayHoldItsEchoLine) {
  RobotWorld slow = world_with("sonar-slow@0");
  drive_for(slow, 0.01);
  EXPECT_EQ(slow.echo_pulse_s(0.004), 0.004);
  EXPECT_EQ(slow.echo_pulse_s(std::nullopt), 0.2);
  EXPECT_EQ(world_with("").echo_pulse_s(std::nullopt), 0.038);
  RobotWorld high = world_with("sonar-high@0");
  drive_for(high, 0.01);
  EXPECT_GT(high.echo_pulse_s(0.004), 3600.0);
}

TEST(RobotWorld, ContactsMayBeNormallyClosedAndTheirWiresMayBreak) {
  const auto closed = [](bool normally_closed, const std::string& faults) {
    RobotParams robot;
    robot.body.contacts_normally_closed = normally_closed;
    RobotWorld world(box_room(), robot, 1, parse_part_faults(faults));
    drive_for(world, 0.01);
    const Contacts contacts = world.closed_contacts();
    return std::pair(contacts.left, contacts.right);
  };
  EXPECT_EQ(closed(false, ""), std::pair(false, false));
  EXPECT_EQ(closed(true, ""), std::pair(true, true));
  EXPECT_EQ(closed(true, "contact-left-broken@0"), std::pair(false, true));
  EXPECT_EQ(closed(false, "contact-right-broken@0"), std::pair(false, false)) << "nobody notices";
}

TEST(RobotWorld, ABatteryMayBeNearlyEmpty) {
  RobotParams robot;
  robot.parts.battery.emplace();
  RobotWorld full(box_room(), robot, 1);
  RobotWorld low(box_room(), robot, 1, parse_part_faults("battery-low@0.1:inf:0.02"));
  drive_for(full, 0.2);
  drive_for(low, 0.2);
  const auto& params = *robot.parts.battery;
  EXPECT_NEAR(full.parts().battery()->volts() - low.parts().battery()->volts(),
              0.98 * (params.full_v - params.empty_v),
              0.01);
}

TEST(RobotWorld, RefusesFaultsOfPartsThatItHasNot) {
  RobotParams blind;
  blind.has_sonar = false;
  EXPECT_THROW(RobotWorld(box_room(), blind, 1, parse_part_faults("sonar-dead@1")),
               std::invalid_argument);
  RobotParams without_bumpers;
  without_bumpers.body.has_bumpers = false;
  EXPECT_THROW(
      RobotWorld(box_room(), without_bumpers, 1, parse_part_faults("contact-left-broken@1")),
      std::invalid_argument);
  EXPECT_THROW(RobotWorld(box_room(), RobotParams{}, 1, parse_part_faults("battery-low@1")),
               std::invalid_argument);
}

/// As its file says, without noise, nearer to the wall on its right than to the one on its left.
RobotWorld exact_world_with(const std::string& faults) {
  return {box_room({}, {2.0, 1.0, 0.0}), exact_robot(), 1, parse_part_faults(faults)};
}

/// Edges forward minus edges backward, as a board decodes the pins.
class EncoderInput {
 public:
  void read(const std::vector<LevelChange>& changes) {
    for (const LevelChange& change : changes) {
      const int a = change.a ? 1 : 0;
      const int phase = change.b ? 3 - a : a;
      counts_ += (phase - phase_ + 4) % 4 == 1 ? 1 : -1;
      phase_ = phase;
    }
  }
  int counts() const { return counts_; }

 private:
  int phase_ = 0;
  int counts_ = 0;
};

/// What the board counts, and where the robot comes to.
struct DrivenWay {
  int left = 0;
  int right = 0;
  geometry::Pose2 T_world_robot;
};

/// Drives for a second.
DrivenWay driven_with(const std::string& faults, const WheelDuty& duty = {0.5, 0.5}) {
  RobotWorld world = exact_world_with(faults);
  EncoderInput left;
  EncoderInput right;
  for (int i = 0; i < 1000; ++i) {
    EncoderChanges changes;
    world.step(0.001, duty, changes);
    left.read(changes.left);
    right.read(changes.right);
  }
  return {left.counts(), right.counts(), world.T_world_robot()};
}

TEST(RobotWorld, AReversedMotorTurnsItsWheelTheOtherWay) {
  const DrivenWay whole = driven_with("");
  const DrivenWay reversed = driven_with("motor-left-reversed@0");
  EXPECT_GT(whole.left, 1000);
  EXPECT_NEAR(reversed.left, -whole.left, 1);
  EXPECT_EQ(reversed.right, whole.right);
  EXPECT_GT(reversed.T_world_robot.heading_rad(), 1.0) << "on the spot";
  EXPECT_NEAR(reversed.T_world_robot.x_m(), 2.0, 1e-3);
}

TEST(RobotWorld, AWheelWithMotorAndEncoderReversedCountsForwardAndGoesBack) {
  const DrivenWay whole = driven_with("");
  const DrivenWay reversed = driven_with("motor-left-reversed@0,encoder-left-reversed@0");
  EXPECT_NEAR(reversed.left, whole.left, 1);
  EXPECT_EQ(reversed.right, whole.right);
  EXPECT_GT(reversed.T_world_robot.heading_rad(), 1.0);
}

TEST(RobotWorld, SwappedMotorsAndSwappedEncodersExchangeTheWheels) {
  const WheelDuty to_the_right{0.6, 0.3};
  const DrivenWay whole = driven_with("", to_the_right);
  EXPECT_GT(whole.left, 2 * whole.right);
  EXPECT_LT(whole.T_world_robot.heading_rad(), -0.5);

  const DrivenWay motors = driven_with("motors-swapped@0", to_the_right);
  EXPECT_NEAR(motors.T_world_robot.heading_rad(), -whole.T_world_robot.heading_rad(), 1e-9);
  EXPECT_EQ(motors.left, whole.right);
  EXPECT_EQ(motors.right, whole.left);

  const DrivenWay encoders = driven_with("encoders-swapped@0", to_the_right);
  EXPECT_EQ(encoders.T_world_robot.heading_rad(), whole.T_world_robot.heading_rad());
  EXPECT_EQ(encoders.left, whole.right);
  EXPECT_EQ(encoders.right, whole.left);
}

TEST(RobotWorld, EncodersOfHalfTheEdgesCountHalfOfTheSameWay) {
  const DrivenWay whole = driven_with("");
  const DrivenWay half = driven_with("counts@0");
  EXPECT_NEAR(half.left, 0.5 * whole.left, 1.0);
  EXPECT_NEAR(half.right, 0.5 * whole.right, 1.0);
  EXPECT_NEAR(half.T_world_robot.x_m(), whole.T_world_robot.x_m(), 1e-9);
}

TEST(RobotWorld, ALargerWheelDrivesAnArcWithTheCountsOfAStraightLine) {
  const DrivenWay larger = driven_with("wheel-left@0:inf:1.08");
  EXPECT_EQ(larger.left, larger.right);
  const DriveParams drive;
  const double rolled_m =
      larger.left * std::numbers::pi * drive.wheel_diameter_m / drive.counts_per_turn;
  EXPECT_NEAR(larger.T_world_robot.heading_rad(), -0.08 * rolled_m / drive.track_m, 1e-3);
  EXPECT_GT(driven_with("wheel-left@0:inf:0.92").T_world_robot.heading_rad(), 0.05);
  EXPECT_GT(driven_with("wheel-right@0:inf:1.08").T_world_robot.heading_rad(), 0.05);
}

TEST(RobotWorld, APanMayTurnTheOtherWayOrLookAside) {
  constexpr double kQuarterTurnRad = 0.5 * std::numbers::pi;
  const auto range_m = [](const std::string& faults, double pan_rad) {
    return exact_world_with(faults).ping(pan_rad).value_or(0.0) * 343.2 / 2.0;
  };
  EXPECT_NEAR(range_m("", kQuarterTurnRad), 2.0, 1e-9);
  EXPECT_NEAR(range_m("pan-reversed@0", kQuarterTurnRad), 1.0, 1e-9);
  EXPECT_NEAR(range_m("pan-off@0:inf:90", 0.0), 2.0, 1e-9);
  EXPECT_NEAR(range_m("pan-off@0:inf:-90", 0.0), 1.0, 1e-9);
  EXPECT_NEAR(exact_world_with("pan-off@0").T_world_sonar(0.5).heading_rad(),
              0.5 + 7.0 / 180.0 * std::numbers::pi,
              1e-9);
}

TEST(RobotWorld, ARangeScaleStretchesTheTimesOfEchoes) {
  EXPECT_NEAR(exact_world_with("range-scale@0:inf:1.1").ping(0.0).value_or(0.0),
              1.1 * 2.0 * 1.97 / 343.2,
              1e-9);
}

/// Somebody crosses before the robot, which stands in the middle of the box room.
FloorPlan crossed_room() {
  const FloorPlan room = box_room();
  FloorMarks marks;
  marks.people.push_back({{{2.6, -0.5}, {2.6, 3.5}}, 1.0, 0.2, 1.0});
  return {"crossed", {room.room_m(), {}}, {}, room.T_world_start(), marks};
}

TEST(RobotWorld, SomebodyWhoCrossesIsHeardAndThenGone) {
  RobotWorld world(crossed_room(), RobotParams{}, 1);
  EncoderChanges changes;
  std::vector<double> heard_m;
  for (int i = 0; i < 6000; ++i) {
    world.step(0.001, {}, changes);
    if (i % 1000 == 999) {
      heard_m.push_back(world.ping(0.0).value_or(0.0) * 343.2 / 2.0);
    }
  }
  ASSERT_EQ(heard_m.size(), 6U);
  EXPECT_NEAR(heard_m[0], 1.97, 0.15) << "the wall";
  EXPECT_NEAR(heard_m[2], 0.37, 0.15) << "the person, after two seconds of its way";
  EXPECT_NEAR(heard_m[5], 1.97, 0.15);
  EXPECT_EQ(world.plan().walls().size(), 4U);
}

TEST(RobotWorld, ARobotThatDrivesIntoSomebodyBumps) {
  const FloorPlan room = box_room();
  FloorMarks marks;
  marks.people.push_back({{{2.5, 1.5}, {2.5, 1.501}, {2.5, 1.6}}, 0.001, 0.2, 0.0});
  RobotWorld world(
      FloorPlan("blocked", {room.room_m(), {}}, {}, room.T_world_start(), marks), RobotParams{}, 1);
  const auto touches = [&] { return world.contacts().left || world.contacts().right; };
  for (int i = 0; i < 100 && !touches(); ++i) {
    drive_for(world, 0.02);
  }
  EXPECT_TRUE(touches());
  EXPECT_NEAR(world.T_world_robot().x_m(), 2.5 - 0.2 - 0.09, 0.02);
}

}  // namespace
}  // namespace echomap::world
