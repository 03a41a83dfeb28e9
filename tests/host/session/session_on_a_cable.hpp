// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_session.hpp"
#include "tests/host/robot_link/fake_robot.hpp"

namespace echomap::session {

/// What a cable between session and fake robot does.
struct Cable {
  robot_link::FakeRobot robot;
  bool plugged = true;
  bool powered = true;
  transport::StreamStatus status = transport::StreamStatus::kOpen;
  bool time_passes = true;
  time::HostTime begin;  ///< Of the session's pace.
};

/// The host's end of it.
class CableStream final : public transport::ByteStream {
 public:
  explicit CableStream(Cable& cable) : cable_(cable) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    const auto bytes = cable_.robot.take_outgoing();
    if (!cable_.plugged || !cable_.powered) {
      return 0;
    }
    EXPECT_LE(bytes.size(), into.size());
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  void write(std::span<const std::uint8_t> bytes) override {
    if (cable_.plugged && cable_.powered) {
      cable_.robot.receive(bytes);
    }
  }
  transport::StreamStatus status() const override { return cable_.status; }
  std::string close_reason() const override {
    return cable_.status == transport::StreamStatus::kOpen ? "" : "pulled out";
  }
  std::string name() const override { return "cable"; }

 private:
  Cable& cable_;
};

/// Five milliseconds of the robot's time a step.
class CablePace final : public Pace {
 public:
  explicit CablePace(Cable& cable) : cable_(cable), now_(cable.begin) {}

  time::HostTime step(transport::ByteStream& stream,
                      std::uint64_t /*bytes_sent*/,
                      const Receive& receive) override {
    if (!cable_.time_passes) {
      return now_;
    }
    for (int i = 0; i < 5 && cable_.powered; ++i) {
      cable_.robot.advance_1ms();
    }
    now_ += std::chrono::milliseconds(5);
    std::array<std::uint8_t, 4096> buffer{};
    receive(std::span(buffer).first(stream.read_some(buffer, std::chrono::microseconds(0))));
    return now_;
  }
  std::string end_reason() const override { return cable_.time_passes ? "" : "no more time"; }

 private:
  Cable& cable_;
  time::HostTime now_;
};

/// A session with a fake robot of profile uno_2wd, in simulated time.
class SessionOnACable : public testing::Test {
 protected:
  SessionOnACable() { cable.robot.power_on(1); }

  /// Runs `action` after that many more milliseconds of the session.
  void after_ms(int ms, std::function<void()> action) {
    session->on_step = [this,
                        at = session->now() + std::chrono::milliseconds(ms),
                        action = std::move(action)]() mutable {
      if (action && session->now() >= at) {
        std::exchange(action, nullptr)();
      }
    };
  }
  void power_cycle() {
    cable.robot.power_on(++boot_id);
    ++restarts;
  }

  Cable cable;
  std::uint16_t boot_id = 1;
  int restarts = 0;
  RobotProfile profile = load_robot_profile("uno_2wd");
  pipeline::RobotPipeline pipeline{profile.geometry};
  std::chrono::milliseconds patience{3000};
  bool may_be_lifted = false;
  RobotConnection new_connection(bool no_reset = false) {
    RobotConnection connection{
        std::make_unique<CableStream>(cable), std::make_unique<CablePace>(cable), 7};
    connection.no_reset = no_reset;
    connection.may_be_lifted = may_be_lifted;
    connection.patience = patience;
    return connection;
  }
  std::unique_ptr<RobotSession> new_session(bool no_reset) {
    return std::make_unique<RobotSession>(new_connection(no_reset), profile, pipeline);
  }
  std::unique_ptr<RobotSession> session = new_session(false);
};

}  // namespace echomap::session
