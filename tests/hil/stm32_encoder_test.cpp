// SPDX-License-Identifier: MIT
/// The STM32F103's timers count wheels far above what the AVR boards can, evenly or not.
#include <cstdint>
#include <cstdio>
#include <tuple>

#include <gtest/gtest.h>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"
#include "tests/hil/turning_wheel.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

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
  TurningWheel left(robot.board(), runner::Wheel::kLeft, {jitter, 1});
  TurningWheel right(robot.board(), runner::Wheel::kRight, {jitter, 2});
  for (int ms = 0; ms < 2000; ++ms) {
    const double rate = ms < 1500 ? edges_per_s : -edges_per_s;
    left.turn(rate, kMs);
    right.turn(-1.0027 * rate, kMs);
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
