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

#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"
#include "tests/hil/turning_wheel.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSeconds = 60;
constexpr std::int16_t kEdgesPerS = 20'000;
constexpr std::uint16_t kEdgesPerS2 = 60'000;

class LoadedRobot : public ::testing::Test {
 protected:
  LoadedRobot() {
    robot_.board().on_trigger = [this](std::int64_t at_ns) { answer_ping(at_ns); };
  }

  void connect() {
    ASSERT_TRUE(robot_.connect());
    const protocol::ConfigureDrive drive{0, 0, 32'000, kEdgesPerS2, 2, 3, 3, 3};
    ASSERT_EQ(robot_.command(drive), CommandStatus::kAccepted);
    ASSERT_EQ(robot_.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
    robot_.forget_heard();
  }

  /// One millisecond: wheels against each other, reversing every six seconds as they are told; 8
  /// kB/s towards the robot.
  void load_ms(std::int64_t ms) {
    constexpr double kChangePerMs = kEdgesPerS2 / 1000.0;
    const auto target = static_cast<std::int16_t>(ms / 6000 % 2 == 0 ? kEdgesPerS : -kEdgesPerS);
    speed_ += std::clamp(target - speed_, -kChangePerMs, kChangePerMs);
    left_.turn(speed_, kMs);
    right_.turn(-speed_, kMs);
    if (ms % 2 == 0) {
      send(protocol::DriveSetpoint{target, static_cast<std::int16_t>(-target), 200});
    } else if (ms % 4 == 1) {
      send(protocol::KeepAlive{200});
    }
    if (ms % 2500 == 2) {
      sweep();
    }
    robot_.run_ms(1);
  }

  template <class M>
  void send(const M& message) {
    robot_.send(message);
    host_bytes_ += protocol::kFrameOverhead + protocol::MessageFacts<M>::kSize;
  }

  void sweep() {
    sweep_id_ = protocol::next_command_id(sweep_id_);
    send(protocol::StartSweep{sweep_id_, -3000, 3000, 600, 0});
  }

  void answer_ping(std::int64_t at_ns) {
    std::uniform_int_distribution<std::int64_t> width_ns(150'000, 23'500'000);
    const std::int64_t rise_ns = at_ns + 460'000 + std::int64_t(random_() % 1000);
    const std::int64_t fall_ns = rise_ns + width_ns(random_);
    robot_.board().schedule_echo(rise_ns, fall_ns);
    widths_us_.push_back(double(fall_ns - rise_ns) * 1e-3);
  }

  /// Compares and drops what has been heard.
  void take_heard() {
    for (const auto& echo : robot_.all<protocol::Echo>()) {
      ASSERT_FALSE(widths_us_.empty());
      worst_echo_us_ = std::max(worst_echo_us_, std::abs(echo.flight_us - widths_us_.front()));
      widths_us_.pop_front();
      ++echoes_;
    }
    for (const auto& status : robot_.all<protocol::Status>()) {
      if (status.stack_free_bytes != 0) {
        least_stack_ = std::min(least_stack_, status.stack_free_bytes);
      }
      status_ = status;
    }
    robot_.forget_heard();
  }

  RobotSession robot_{release_image()};
  TurningWheel left_{robot_.board(), runner::Wheel::kLeft};
  TurningWheel right_{robot_.board(), runner::Wheel::kRight};
  double speed_ = 0.0;
  std::mt19937 random_{4711};
  std::deque<double> widths_us_;
  double worst_echo_us_ = 0.0;
  int echoes_ = 0;
  std::uint8_t sweep_id_ = 100;
  std::uint16_t least_stack_ = UINT16_MAX;
  std::uint64_t host_bytes_ = 0;
  protocol::Status status_{};
};

TEST_F(LoadedRobot, LosesNoCountNoFrameAndNoMicrosecondInAMinute) {
  connect();
  const std::size_t bytes_before = robot_.bytes().size();
  const auto wall_start = std::chrono::steady_clock::now();
  for (std::int64_t ms = 0; ms < kSeconds * 1000; ++ms) {
    load_ms(ms);
    if (ms % 100 == 0) {
      ASSERT_NO_FATAL_FAILURE(take_heard());
    }
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  robot_.run_ms(150);  // less than the time to live
  const auto odometry = robot_.last<protocol::Odometry>();
  ASSERT_NO_FATAL_FAILURE(take_heard());

  const double robot_bytes = double(robot_.bytes().size() - bytes_before);
  std::printf("load: %.0f s, %.0f B/s in, %.0f B/s out, %d echoes, worst echo error %.2f us\n",
              double(kSeconds),
              double(host_bytes_) / kSeconds,
              robot_bytes / kSeconds,
              echoes_,
              worst_echo_us_);
  std::printf(
      "load: encoder errors %d, frames bad %d, lost %d, overruns %d, dropped %d, stack %d B\n",
      status_.encoder_errors,
      status_.frames_bad,
      status_.frames_lost,
      status_.receive_overruns,
      status_.telemetry_dropped,
      least_stack_);
  std::printf("load: %.1f simulated seconds per wall second\n", kSeconds / wall.count());
  RecordProperty("worst_echo_error_us", std::to_string(worst_echo_us_));
  RecordProperty("stack_free_bytes", least_stack_);

  ASSERT_TRUE(odometry);
  EXPECT_EQ(odometry->left_ticks, static_cast<std::int16_t>(left_.count()));
  EXPECT_EQ(odometry->right_ticks, static_cast<std::int16_t>(right_.count()));
  EXPECT_EQ(status_.encoder_errors, 0);
  EXPECT_EQ(status_.move_outcome, static_cast<std::uint8_t>(protocol::MotionOutcome::kNone))
      << "the wheels were under control until the end";
  EXPECT_GT(echoes_, 200);
  EXPECT_LE(worst_echo_us_, 1.0);
  EXPECT_EQ(status_.frames_bad, 0);
  EXPECT_EQ(status_.frames_lost, 0);
  EXPECT_EQ(status_.receive_overruns, 0);
  EXPECT_EQ(robot_.counters().frames_bad(), 0);
  EXPECT_GE(least_stack_, 400);
}

}  // namespace
}  // namespace echomap::tests
