// SPDX-License-Identifier: MIT
#include "host/pipeline/joined_sessions.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_times.hpp"

namespace echomap::pipeline {
namespace {

using ::testing::ElementsAre;
using tests::at_us;

/// Notes what it takes.
class Notes final : public ObservationSink {
 public:
  void on_odometry(const sensors::OdometryObservation& observation) override {
    note(observation.stamp, observation.travel);
  }
  void on_sonar(const sensors::SonarObservation& observation) override {
    note(observation.stamp, observation.travel);
    EXPECT_EQ(observation.pan_rad, 0.5);
    EXPECT_EQ(observation.range_m, 1.5);
  }
  void on_infrared(const sensors::InfraredObservation& observation) override {
    note(observation.stamp, observation.travel);
    EXPECT_THAT(observation.range_m, ElementsAre(0.25));
  }
  void on_hazards(const sensors::HazardObservation& observation) override {
    stamps_us.push_back(observation.stamp.time_since_epoch().count());
    hazards = observation;
  }
  void on_carried(const sensors::CarriedObservation& observation) override {
    note(observation.stamp, observation.travel);
    T_map_robot = observation.T_map_robot;
  }
  void on_pose_fix(const sensors::PoseFixObservation& observation) override {
    stamps_us.push_back(observation.stamp.time_since_epoch().count());
    T_map_robot = observation.T_map_robot;
  }
  void on_yaw(const sensors::YawObservation& observation) override {
    stamps_us.push_back(observation.stamp.time_since_epoch().count());
  }
  void on_battery(const sensors::BatteryObservation& observation) override {
    stamps_us.push_back(observation.stamp.time_since_epoch().count());
  }
  void begin_scan() override { scans += '('; }
  void end_scan() override { scans += ')'; }

  std::vector<std::int64_t> stamps_us;
  std::vector<double> left_m;
  std::vector<double> right_m;
  sensors::HazardObservation hazards;
  std::string scans;
  geometry::Pose2 T_map_robot;

 private:
  void note(time::RobotTime stamp, const sensors::WheelTravel& travel) {
    stamps_us.push_back(stamp.time_since_epoch().count());
    left_m.push_back(travel.left_m);
    right_m.push_back(travel.right_m);
  }
};

class JoinedSessionsTest : public ::testing::Test {
 protected:
  Notes notes;
  JoinedSessions sessions{notes};
};

TEST_F(JoinedSessionsTest, TheFirstSessionGoesThroughAsItIs) {
  sessions.begin_scan();
  sessions.on_odometry({at_us(300), {0.1, 0.2}});
  sessions.on_sonar({at_us(200), {0.05, 0.15}, 0.5, 1.5});
  sessions.end_scan();
  EXPECT_THAT(notes.stamps_us, ElementsAre(300, 200));
  EXPECT_THAT(notes.left_m, ElementsAre(0.1, 0.05));
  EXPECT_EQ(notes.scans, "()");
}

TEST_F(JoinedSessionsTest, TheNextBeginsWhereTheLastHasEnded) {
  sessions.on_odometry({at_us(1000), {1.0, 2.0}});
  sessions.begin_next();
  sessions.on_odometry({at_us(70), {10.0, 10.0}});
  sessions.on_sonar({at_us(80), {10.5, 10.25}, 0.5, 1.5});
  sessions.on_infrared({at_us(90), {11.0, 10.5}, {0.25}});
  sessions.on_yaw({at_us(100), {}});
  sessions.on_battery({at_us(110), 7.4});
  sessions.on_hazards({.stamp = at_us(120)});
  EXPECT_THAT(notes.stamps_us, ElementsAre(1000, 1000, 1000, 1010, 1020, 1030, 1040, 1050));
  EXPECT_THAT(notes.left_m, ElementsAre(1.0, 1.0, 1.5, 2.0));
  EXPECT_THAT(notes.right_m, ElementsAre(2.0, 2.0, 2.25, 2.5));
}

TEST_F(JoinedSessionsTest, EveryFurtherSessionGoesOnFromTheOneBefore) {
  for (int i = 0; i < 3; ++i) {
    sessions.on_odometry({at_us(5), {1.0, 1.0}});
    sessions.on_odometry({at_us(15), {1.5, 1.25}});
    sessions.begin_next();
  }
  EXPECT_EQ(notes.stamps_us.back(), 35);
  EXPECT_EQ(notes.left_m.back(), 2.5);
  EXPECT_EQ(notes.right_m.back(), 1.75);
}

TEST_F(JoinedSessionsTest, GoesOnFromTheLatestStampWhereMessagesCameLate) {
  sessions.on_odometry({at_us(1000), {1.0, 1.0}});
  sessions.on_odometry({at_us(900), {0.9, 0.9}});
  sessions.begin_next();
  sessions.on_odometry({at_us(1), {}});
  EXPECT_EQ(notes.stamps_us.back(), 1000);
  EXPECT_EQ(notes.left_m.back(), 0.9) << "where the pipeline has the wheels";
}

TEST_F(JoinedSessionsTest, HandsOnWhereTheRobotWasCarried) {
  sessions.on_odometry({at_us(10), {1.0, 1.0}});
  sessions.begin_next();
  sessions.on_odometry({at_us(5), {}});
  sessions.on_carried({at_us(7), {0.5, 0.25}, {3.0, 4.0, 1.0}});
  EXPECT_EQ(notes.stamps_us.back(), 12);
  EXPECT_EQ(notes.left_m.back(), 1.5);
  EXPECT_EQ(notes.right_m.back(), 1.25);
  EXPECT_EQ(notes.T_map_robot.x_m(), 3.0);
  sessions.on_pose_fix({at_us(8), {5.0, 4.0, 1.0}});
  EXPECT_EQ(notes.stamps_us.back(), 13);
  EXPECT_EQ(notes.T_map_robot.x_m(), 5.0);
}

TEST_F(JoinedSessionsTest, EndsAnOpenScanAndWhatTouchedTheRobot) {
  sessions.begin_scan();
  sensors::HazardObservation hazards;
  hazards.stamp = at_us(10);
  hazards.lifted = true;
  sessions.on_hazards(hazards);
  sessions.begin_next();
  EXPECT_EQ(notes.scans, "()");
  EXPECT_FALSE(notes.hazards.lifted);
}

}  // namespace
}  // namespace echomap::pipeline
