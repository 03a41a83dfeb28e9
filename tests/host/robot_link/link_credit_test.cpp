// SPDX-License-Identifier: MIT
#include <algorithm>
#include <deque>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

/// A robot behind a line of 9600 baud that looks into its receive buffer of 128 bytes now and then
/// only. What finds no room there is lost and counted, as in the firmware's SerialPort.
class SlowRobot {
 public:
  static constexpr std::size_t kBufferBytes = 128;
  static constexpr double kBytesPerMs = 0.96;

  explicit SlowRobot(std::mt19937& random) : to_robot(2, random), to_host(2, random) {}

  void advance_1ms(int now_ms) {
    robot.advance_1ms();
    for (const std::uint8_t byte : to_robot.take(now_ms)) {
      line_.push_back(byte);
    }
    for (line_room_ += kBytesPerMs; line_room_ >= 1.0; line_room_ -= 1.0) {
      carry_one_byte();
    }
    if (now_ms % busy_ms == 0) {
      robot.receive(std::exchange(buffer_, {}));
    }
    to_host.put(robot.take_outgoing(), now_ms);
  }

  /// Bytes that were sent and neither taken nor lost.
  std::size_t waiting_bytes() const { return line_.size() + buffer_.size(); }

  SimulatedLine to_robot;
  SimulatedLine to_host;
  FakeRobot robot;
  int busy_ms = 150;  ///< Between two looks into the buffer.
  int overruns = 0;

 private:
  void carry_one_byte() {
    if (line_.empty()) {
      return;
    }
    if (buffer_.size() < kBufferBytes) {
      buffer_.push_back(line_.front());
    } else {
      ++overruns;
    }
    line_.pop_front();
  }

  std::deque<std::uint8_t> line_;
  std::vector<std::uint8_t> buffer_;
  double line_room_ = 0.0;
};

class LinkCredit : public testing::Test {
 protected:
  void run_for(int duration_ms) {
    for (const int end_ms = now_ms + duration_ms; now_ms < end_ms; ++now_ms) {
      slow.advance_1ms(now_ms);
      link.receive(slow.to_host.take(now_ms), now());
      on_ms();
      link.poll(now());
      slow.to_robot.put(link.take_outgoing(), now_ms);
      max_waiting = std::max(max_waiting, slow.waiting_bytes());
    }
  }
  time::HostTime now() const { return time::HostTime(std::chrono::milliseconds(now_ms)); }

  int now_ms = 0;
  std::mt19937 random{3};
  SlowRobot slow{random};
  RecordingListener listener;
  RobotLink link{listener, 0x5E55, wired_link(9600)};
  std::function<void()> on_ms = [] {};
  std::size_t max_waiting = 0;
};

TEST_F(LinkCredit, SparesARobotWhoseBufferWouldOverflow) {
  run_for(1000);
  ASSERT_EQ(link.state(), LinkState::kReady);
  link.keep_alive(true);
  on_ms = [this] { link.send(protocol::DriveSetpoint{100, 100, 200}, now()); };
  for (int i = 0; i < 20; ++i) {
    link.submit(protocol::Stop{});
  }
  run_for(20'000);
  EXPECT_EQ(slow.overruns, 0);
  EXPECT_LE(max_waiting, 128U);
  EXPECT_GT(max_waiting, 64U) << "the load did not reach the credit";
  EXPECT_EQ(listener.results.size(), 20U);
  EXPECT_GT(slow.robot.keep_alives.size(), 50U);
  EXPECT_GT(slow.robot.setpoints.size(), 50U);
  EXPECT_GT(link.statistics().setpoints_dropped, 10'000U);
}

TEST_F(LinkCredit, OverflowsTheBufferOfARobotThatGrantsMoreThanItHas) {
  slow.robot.receive_credit_bytes = 1000;
  run_for(1000);
  on_ms = [this] { link.send(protocol::DriveSetpoint{100, 100, 200}, now()); };
  run_for(5000);
  EXPECT_GT(slow.overruns, 100) << "the test above shows nothing";
}

TEST_F(LinkCredit, SendsTheLatestSetpointOfThoseThatWaited) {
  run_for(1000);
  std::int16_t last = 0;
  on_ms = [&] { link.send(protocol::DriveSetpoint{++last, 0, 200}, now()); };
  run_for(1000);
  on_ms = [] {};
  run_for(1000);
  ASSERT_FALSE(slow.robot.setpoints.empty());
  EXPECT_EQ(slow.robot.setpoints.back().left_ticks_per_s, last);
}

TEST_F(LinkCredit, GivesUpASetpointThatWaitedLongerThanItLives) {
  run_for(1000);
  slow.robot.answers_pings = false;
  for (int i = 0; i < 20; ++i) {
    link.send(protocol::DriveSetpoint{1, 1, 50}, now());
  }
  link.send(protocol::DriveSetpoint{77, 1, 50}, now());
  run_for(2000);
  ASSERT_FALSE(slow.robot.setpoints.empty());
  EXPECT_EQ(slow.robot.setpoints.back().left_ticks_per_s, 1);
}

/// Random loads on random lines: what waits at the robot never exceeds its credit, and every
/// command comes to its end.
class LinkCreditUnderLoad : public LinkCredit, public testing::WithParamInterface<std::uint32_t> {
 protected:
  bool one_in(unsigned n) { return random() % n == 0; }
};

TEST_P(LinkCreditUnderLoad, NeverExceedsTheCreditAndNeverStandsStill) {
  random.seed(GetParam());
  slow.busy_ms = 1 + static_cast<int>(random() % 150);
  slow.to_robot.faults =
      slow.to_host.faults = {.lost = 0.02 * static_cast<int>(random() % 11), .damaged = 0.02};
  slow.robot.receive_credit_bytes = static_cast<std::uint16_t>(64 + random() % 65);
  const auto setpoint_every_ms = static_cast<unsigned>(1 + random() % 60);
  std::size_t submitted = 0;
  run_for(1000);
  on_ms = [&] {
    link.keep_alive(now_ms % 5000 < 4000);
    if (one_in(setpoint_every_ms)) {
      link.send(protocol::DriveSetpoint{1, 1, 200}, now());
    }
    if (one_in(300)) {
      link.submit(protocol::MoveTicks{0, 1, 1, 100, 200});
      ++submitted;
    }
  };
  run_for(20'000);
  on_ms = [] {};
  run_for(60'000);
  EXPECT_LE(max_waiting, slow.robot.receive_credit_bytes);
  EXPECT_EQ(slow.overruns, 0);
  EXPECT_EQ(listener.results.size(), submitted);
  EXPECT_EQ(link.state(), LinkState::kReady);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LinkCreditUnderLoad, testing::Range(1U, 101U));

}  // namespace
}  // namespace echomap::robot_link
