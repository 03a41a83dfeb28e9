// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_log.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/robot_times.hpp"

namespace echomap::pipeline {
namespace {

using tests::at_us;

std::string whole(double value) { return std::to_string(std::lround(value)); }

/// Writes down what it takes: the left wheel at an odometry, where the robot was carried to.
class Story final : public ObservationSink {
 public:
  void on_odometry(const sensors::OdometryObservation& observation) override {
    text += "o" + whole(observation.travel.left_m) + " ";
  }
  void on_sonar(const sensors::SonarObservation& /*observation*/) override { text += "s "; }
  void on_hazards(const sensors::HazardObservation& /*observation*/) override { text += "h "; }
  void on_infrared(const sensors::InfraredObservation& /*observation*/) override { text += "i "; }
  void on_scalar(const sensors::ScalarObservation& observation) override {
    text += "n" + whole(observation.count) + " ";
  }
  void on_carried(const sensors::CarriedObservation& carried) override {
    text += "c" + whole(carried.travel.left_m) + "@" + whole(carried.T_map_robot.x_m()) + "," +
            whole(carried.T_map_robot.y_m()) + " ";
  }
  void on_pose_fix(const sensors::PoseFixObservation& fix) override {
    text += "f@" + whole(fix.T_map_robot.x_m()) + "," + whole(fix.T_map_robot.y_m()) + " ";
  }
  void begin_scan() override { text += "( "; }
  void end_scan() override { text += ") "; }

  std::string text;
};

std::string story_of(const ObservationLog& log) {
  Story story;
  log.replay(story);
  return story.text;
}

class ObservationLogTest : public ::testing::Test {
 protected:
  void drive_to(double left_m) { log.on_odometry({at_us(++stamp_us), {left_m, left_m}}); }
  void stop() {
    log.begin_scan();
    log.on_sonar({at_us(++stamp_us), {9.0, 9.0}, 0.0, 1.0});
    log.end_scan();
  }

  ObservationLog log;
  std::int64_t stamp_us = 0;
};

TEST_F(ObservationLogTest, HandsOnWhatItHasTakenInItsOrder) {
  drive_to(1);
  log.on_infrared({});
  stop();
  log.on_hazards({});
  log.on_scalar({at_us(6), {1.0, 1.0}, 12.0, 0.5});
  log.on_carried({at_us(7), {1.0, 1.0}, {3.0, 4.0, 0.5}});
  EXPECT_EQ(story_of(log), "o1 i ( s ) h n12 c1@3,4 ");
  EXPECT_EQ(log.scans(), 1U);
  EXPECT_EQ(story_of(ObservationLog()), "");
}

TEST_F(ObservationLogTest, OnlyAScanThatIsOpenEnds) {
  log.end_scan();
  EXPECT_EQ(log.scans(), 0U);
  log.begin_scan();
  log.begin_scan();
  log.end_scan();
  log.end_scan();
  EXPECT_EQ(story_of(log), "( ) ( ) ");
}

TEST_F(ObservationLogTest, TheLastScansAreTakenOffWithoutTheWayToThem) {
  drive_to(1);
  stop();
  drive_to(2);
  drive_to(3);
  stop();
  drive_to(4);
  stop();
  drive_to(5);
  const ObservationLog later = log.split_off(2);
  EXPECT_EQ(story_of(log), "o1 ( s ) ");
  EXPECT_EQ(story_of(later), "c3@0,0 ( s ) o4 ( s ) o5 ");
}

TEST_F(ObservationLogTest, AllScansAreTakenOffWhereThereAreNoMore) {
  drive_to(1);
  stop();
  const ObservationLog later = log.split_off(3);
  EXPECT_EQ(story_of(log), "");
  EXPECT_EQ(story_of(later), "c0@0,0 o1 ( s ) ");
  EXPECT_EQ(story_of(ObservationLog().split_off(2)), "");
}

TEST_F(ObservationLogTest, OnlyScansSinceTheRobotWasPutDownAreTakenOff) {
  stop();
  log.on_carried({at_us(7), {2.0, 2.0}, {3.0, 4.0, 0.5}});
  stop();
  const ObservationLog later = log.split_off(2);
  EXPECT_EQ(log.scans(), 1U);
  EXPECT_EQ(story_of(later), "c2@0,0 ( s ) ");
}

TEST_F(ObservationLogTest, WhatComesAfterALiftIsLetGo) {
  drive_to(1);
  stop();
  drive_to(2);
  log.begin_scan();
  log.on_hazards({.stamp = at_us(8), .lifted = true});
  drive_to(3);
  const ObservationLog later = log.split_off_lift();
  EXPECT_EQ(story_of(log), "o1 ( s ) o2 ");
  EXPECT_EQ(story_of(later), "c3@0,0 ");
}

TEST_F(ObservationLogTest, TwoAreJoinedInTheFrameOfTheFirstByTheirTime) {
  ObservationLog first;
  first.on_odometry({at_us(1), {1.0, 1.0}});
  ObservationLog second;
  second.on_carried({at_us(10), {2.0, 2.0}, {}});
  ObservationLog third;
  third.on_carried({at_us(20), {3.0, 3.0}, {}});
  third.on_pose_fix({at_us(21), {1.0, 1.0, 0.0}});
  const geometry::Pose2 T_first_third(5.0, 6.0, 0.0);
  const ObservationLog both = joined(third, first, T_first_third.inverse());
  EXPECT_EQ(story_of(both), "o1 c3@5,6 f@6,7 ");
  EXPECT_EQ(story_of(joined(second, both, geometry::Pose2(1.0, 0.0, 0.0))),
            "o1 c2@-1,0 c3@5,6 f@6,7 ");
}

}  // namespace
}  // namespace echomap::pipeline
