// SPDX-License-Identifier: MIT
/// The STM32F103's timers count wheels far above what the AVR boards can, evenly or not.
#include <cstdint>
#include <cstdio>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {
namespace {

/// A wheel whose every edge comes early or late by up to a share of the time between two.
class UnevenWheel {
 public:
  UnevenWheel(RobotSession& robot, runner::Wheel wheel, double edges_per_s, double jitter)
      : robot_(robot), wheel_(wheel), edge_ns_(1e9 / edges_per_s), shift_(-jitter, jitter) {}

  /// Schedules the edges of the next millisecond.
  void turn_one_ms(int direction) {
    constexpr double kMsNs = 1e6;
    const double start_ns = double(robot_.board().now_ns());
    for (; next_ns_ < kMsNs; next_ns_ += edge_ns_) {
      count_ += direction;
      const auto phase = static_cast<unsigned>(count_) & 3U;
      const double at_ns = start_ns + next_ns_ + edge_ns_ * (1.0 + shift_(generator_));
      robot_.board().schedule_encoder_edge(
          wheel_, std::int64_t(at_ns), phase == 1 || phase == 2, phase >= 2);
    }
    next_ns_ -= kMsNs;
  }

  std::int64_t count() const { return count_; }

 private:
  RobotSession& robot_;
  runner::Wheel wheel_;
  double edge_ns_;
  std::uniform_real_distribution<double> shift_;
  std::mt19937 generator_{4711};
  double next_ns_ = 0.0;
  std::int64_t count_ = 0;
};

class Stm32Encoders : public ::testing::TestWithParam<std::tuple<int, int>> {};

INSTANTIATE_TEST_SUITE_P(EdgesPerSAndJitterPercent,
                         Stm32Encoders,
                         ::testing::Combine(::testing::Values(40'000, 80'000, 200'000),
                                            ::testing::Values(0, 20, 40)),
                         [](const auto& test) {
                           return std::to_string(std::get<0>(test.param)) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST_P(Stm32Encoders, CountEveryEdgeOfBothWheels) {
  const auto [edges_per_s, jitter_percent] = GetParam();
  RobotSession robot{release_image("echomap-stm32f103")};
  ASSERT_TRUE(robot.connect());
  const double jitter = jitter_percent / 100.0;
  UnevenWheel left(robot, runner::Wheel::kLeft, edges_per_s, jitter);
  UnevenWheel right(robot, runner::Wheel::kRight, 1.0027 * edges_per_s, jitter);
  for (int ms = 0; ms < 2000; ++ms) {
    left.turn_one_ms(ms < 1500 ? 1 : -1);
    right.turn_one_ms(ms < 1500 ? -1 : 1);
    robot.run_ms(1);
  }
  robot.run_ms(200);
  ASSERT_TRUE(robot.last<protocol::Odometry>());
  const protocol::Odometry told = *robot.last<protocol::Odometry>();
  const auto miscounts = [](std::int64_t wanted, std::int64_t counted) {
    return static_cast<std::int16_t>(wanted - counted);
  };
  EXPECT_EQ(miscounts(left.count(), told.left_ticks), 0);
  EXPECT_EQ(miscounts(right.count(), told.right_ticks), 0);
  EXPECT_GT(left.count(), edges_per_s / 2);
}

TEST(Stm32EncoderJumps, AreNotToldAsLostForATimerCannotSeeThemAndTheGreetingSaysSo) {
  RobotSession robot{release_image("echomap-stm32f103")};
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_TRUE((reply->capabilities & protocol::kCapabilityBlindEncoders) != 0);
  for (int i = 0; i < 10; ++i) {
    const bool high = i % 2 == 0;
    robot.board().schedule_encoder_edge(runner::Wheel::kLeft, robot.board().now_ns(), high, high);
    robot.run_ms(2);
  }
  robot.forget_heard();
  robot.run_ms(1100);  // Health comes once a second
  ASSERT_TRUE(robot.last<protocol::Health>());
  EXPECT_EQ(robot.last<protocol::Health>()->encoder_errors, 0);
  EXPECT_FALSE(robot.last<protocol::EncoderErrors>());
}

}  // namespace
}  // namespace echomap::tests
