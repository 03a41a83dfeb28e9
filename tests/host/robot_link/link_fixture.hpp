// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/robot_link/robot_link.hpp"
#include "tests/host/robot_link/fake_robot.hpp"
#include "tests/host/robot_link/simulated_line.hpp"

namespace echomap::robot_link {

/// Notes everything that a link tells, in order.
struct RecordingListener : RobotLinkListener {
  void on_odometry(const protocol::Odometry& message) override { odometry.push_back(message); }
  void on_echo(const protocol::Echo& message) override { echoes.push_back(message); }
  void on_status(const protocol::Status& message) override { statuses.push_back(message); }
  void on_bulk(const BulkResult& result) override { bulk.push_back(result); }
  void on_ready(const protocol::HelloReply& /*reply*/) override { events.emplace_back("ready"); }
  void on_reset(std::uint8_t reset_cause) override {
    events.emplace_back("reset");
    reset_causes.push_back(reset_cause);
  }
  void on_command_done(const CommandResult& result) override {
    events.emplace_back(to_string(result.outcome));
    results.push_back(result);
  }

  std::vector<std::string> events;
  std::vector<std::uint8_t> reset_causes;
  std::vector<CommandResult> results;
  std::vector<BulkResult> bulk;
  std::vector<protocol::Odometry> odometry;
  std::vector<protocol::Echo> echoes;
  std::vector<protocol::Status> statuses;
};

/// A host and a robot on a cable of two milliseconds, in simulated time.
class LinkFixture : public testing::Test {
 protected:
  explicit LinkFixture(const RobotLinkParams& params = {}) : link(listener, 0x5E55, params) {}

  void run_for(int duration_ms) {
    for (int end_ms = now_ms + duration_ms; now_ms < end_ms; ++now_ms) {
      if (robot_has_power) {
        robot.advance_1ms();
        robot.receive(to_robot.take(now_ms));
        to_host.put(robot.take_outgoing(), now_ms);
      } else {
        to_robot.take(now_ms);
      }
      link.receive(to_host.take(now_ms), now());
      link.poll(now());
      to_robot.put(link.take_outgoing(), now_ms);
    }
  }

  time::HostTime now() const { return time::HostTime(std::chrono::milliseconds(now_ms)); }

  int now_ms = 0;
  bool robot_has_power = true;
  std::mt19937 random{11};
  SimulatedLine to_robot{2, random};
  SimulatedLine to_host{2, random};
  FakeRobot robot;
  RecordingListener listener;
  RobotLink link;
};

}  // namespace echomap::robot_link
