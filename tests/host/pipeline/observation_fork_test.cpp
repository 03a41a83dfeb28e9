// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_fork.hpp"

#include <string>

#include <gtest/gtest.h>

namespace echomap::pipeline {
namespace {

/// Writes down what it takes.
class CallNotes final : public ObservationSink {
 public:
  void on_odometry(const sensors::OdometryObservation& /*observation*/) override { text += 'o'; }
  void on_sonar(const sensors::SonarObservation& /*observation*/) override { text += 's'; }
  void on_hazards(const sensors::HazardObservation& /*observation*/) override { text += 'h'; }
  void on_infrared(const sensors::InfraredObservation& /*observation*/) override { text += 'i'; }
  void on_yaw(const sensors::YawObservation& /*observation*/) override { text += 'y'; }
  void on_battery(const sensors::BatteryObservation& /*observation*/) override { text += 'b'; }
  void on_carried(const sensors::CarriedObservation& /*observation*/) override { text += 'c'; }
  void on_pose_fix(const sensors::PoseFixObservation& /*observation*/) override { text += 'f'; }
  void begin_scan() override { text += '('; }
  void end_scan() override { text += ')'; }

  std::string text;
};

void tell_everything(ObservationSink& sink) {
  sink.begin_scan();
  sink.on_odometry({});
  sink.on_sonar({});
  sink.on_hazards({});
  sink.on_infrared({});
  sink.on_yaw({});
  sink.on_battery({});
  sink.on_carried({});
  sink.on_pose_fix({});
  sink.end_scan();
}

TEST(ObservationFork, HandsEverythingOnToThoseThatListen) {
  CallNotes first;
  CallNotes second;
  ObservationFork fork;
  fork.add(first);
  fork.add(second);
  tell_everything(fork);
  EXPECT_EQ(first.text, "(oshiybcf)");
  EXPECT_EQ(second.text, first.text);
  fork.remove(first);
  tell_everything(fork);
  EXPECT_EQ(first.text, "(oshiybcf)");
  EXPECT_EQ(second.text, "(oshiybcf)(oshiybcf)");
}

}  // namespace
}  // namespace echomap::pipeline
