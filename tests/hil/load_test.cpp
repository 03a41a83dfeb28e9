// SPDX-License-Identifier: MIT
/// The firmware at the load that it is built for: 20,000 edges a second on both wheels under speed
/// control, frames both ways without a pause, the sonar pinging, for a minute.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"
#include "tests/hil/turning_wheel.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSeconds = 60;
constexpr std::int16_t kEdgesPerS = 20'000;
constexpr std::uint16_t kEdgesPerS2 = 60'000;

class LoadedRobot : public OnEveryBoard {
 protected:
  LoadedRobot() {
    robot.board().on_trigger = [this](std::int64_t at_ns) { answer_ping(at_ns); };
  }

  void connect() {
    ASSERT_TRUE(robot.connect());
    const protocol::ConfigureDrive drive{0, 0, 32'000, kEdgesPerS2, 2, 3, 3, 3};
    ASSERT_EQ(robot.command(drive), CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
    robot.forget_heard();
  }

  /// One millisecond: wheels against each other, reversing every six seconds as they are told; 8
  /// kB/s towards the robot.
  void load_ms(std::int64_t ms) {
    constexpr double kChangePerMs = kEdgesPerS2 / 1000.0;
    const auto target = static_cast<std::int16_t>(ms / 6000 % 2 == 0 ? kEdgesPerS : -kEdgesPerS);
    speed += std::clamp(target - speed, -kChangePerMs, kChangePerMs);
    left.turn(speed, kMs);
    right.turn(-speed, kMs);
    if (ms % 2 == 0) {
      send(protocol::DriveSetpoint{target, static_cast<std::int16_t>(-target), 200});
    } else if (ms % 4 == 1) {
      send(protocol::KeepAlive{200});
    }
    if (ms % 2500 == 2) {
      sweep();
    }
    robot.run_ms(1);
  }

  template <class M>
  void send(const M& message) {
    robot.send(message);
    host_bytes += protocol::kFrameOverhead + protocol::MessageFacts<M>::kSize;
  }

  void sweep() {
    sweep_id = protocol::next_command_id(sweep_id);
    send(protocol::StartSweep{sweep_id, -3000, 3000, 600, 0});
  }

  void answer_ping(std::int64_t at_ns) {
    const std::int64_t rise_ns = at_ns + 460'000 + std::int64_t(generator() % 1'000);
    const std::int64_t fall_ns = rise_ns + 150'000 + std::int64_t(generator() % 23'350'000);
    robot.board().schedule_echo(rise_ns, fall_ns);
    widths_us.push_back(double(fall_ns - rise_ns) * 1e-3);
  }

  /// Compares and drops what has been heard.
  void take_heard() {
    for (const auto& echo : robot.all<protocol::Echo>()) {
      ASSERT_FALSE(widths_us.empty());
      worst_echo_us = std::max(worst_echo_us, std::abs(echo.flight_us - widths_us.front()));
      widths_us.pop_front();
      ++echoes;
    }
    last_status = robot.last<protocol::Status>().value_or(last_status);
    for (const auto& health : robot.all<protocol::Health>()) {
      if (health.stack_free_bytes != 0) {  // 0: not yet known.
        least_stack = std::min(least_stack, health.stack_free_bytes);
      }
      last_health = health;
    }
    robot.forget_heard();
  }

  TurningWheel left{robot.board(), runner::Wheel::kLeft};
  TurningWheel right{robot.board(), runner::Wheel::kRight};
  double speed = 0.0;
  std::mt19937 generator{4711};
  std::deque<double> widths_us;
  double worst_echo_us = 0.0;
  int echoes = 0;
  std::uint8_t sweep_id = 100;
  std::uint16_t least_stack = UINT16_MAX;
  std::uint64_t host_bytes = 0;
  protocol::Status last_status{};
  protocol::Health last_health{};
};

INSTANTIATE_TEST_SUITE_P(Boards, LoadedRobot, every_board(), image_label);

TEST_P(LoadedRobot, LosesNoCountNoFrameAndNoMicrosecondInAMinute) {
  connect();
  const std::size_t bytes_before = robot.bytes().size();
  const auto wall_start = std::chrono::steady_clock::now();
  for (std::int64_t ms = 0; ms < kSeconds * 1000; ++ms) {
    load_ms(ms);
    if (ms % 100 == 0) {
      ASSERT_NO_FATAL_FAILURE(take_heard());
    }
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  robot.run_ms(150);  // less than the time to live
  const auto odometry = robot.last<protocol::Odometry>();
  ASSERT_NO_FATAL_FAILURE(take_heard());

  const double robot_bytes = double(robot.bytes().size() - bytes_before);
  std::printf("%s: %.0f s, %.0f B/s in, %.0f B/s out, %d echoes, worst echo error %.2f us\n",
              GetParam(),
              double(kSeconds),
              double(host_bytes) / kSeconds,
              robot_bytes / kSeconds,
              echoes,
              worst_echo_us);
  std::printf("  encoder errors %d, frames bad %d, lost %d, overruns %d, dropped %d, stack %d B\n",
              last_health.encoder_errors,
              last_health.frames_bad,
              last_health.frames_lost,
              last_health.receive_overruns,
              last_health.telemetry_dropped,
              least_stack);
  std::printf("  %.1f simulated seconds per wall second\n", kSeconds / wall.count());
  RecordProperty("worst_echo_error_us", std::to_string(worst_echo_us));
  RecordProperty("stack_free_bytes", least_stack);

  ASSERT_TRUE(odometry);
  EXPECT_EQ(odometry->left_ticks, static_cast<std::int16_t>(left.count()));
  EXPECT_EQ(odometry->right_ticks, static_cast<std::int16_t>(right.count()));
  EXPECT_EQ(last_health.encoder_errors, 0);
  EXPECT_EQ(last_status.move_outcome, static_cast<std::uint8_t>(protocol::MotionOutcome::kNone))
      << "the wheels were under control until the end";
  EXPECT_GT(echoes, 200);
  EXPECT_LE(worst_echo_us, 1.0);
  EXPECT_EQ(last_health.frames_bad, 0);
  EXPECT_EQ(last_health.frames_lost, 0);
  EXPECT_EQ(last_health.receive_overruns, 0);
  EXPECT_EQ(robot.counters().frames_bad(), 0);
  const avr_t& chip = robot.board().machine().core();
  EXPECT_GE(least_stack, 400);
  EXPECT_LT(least_stack, chip.ramend - chip.ioend) << "nothing was painted";
}

}  // namespace
}  // namespace echomap::tests
