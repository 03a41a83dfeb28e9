// SPDX-License-Identifier: MIT
/// The firmware at the loads that it is built for, compared with what went into its pins.
#include <cstdio>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

LoadResult run_under(const std::string& image, const Load& load, double seconds) {
  LoadedRobot robot(release_image(image), load);
  robot.connect();
  robot.run_s(seconds);
  const LoadResult result = robot.finish();
  std::printf("%s: %lld edges in %.0f s, %.0f B/s in, %.0f B/s out, %d echoes\n",
              image.c_str(),
              static_cast<long long>(result.edges),
              seconds,
              result.host_bytes_per_s,
              result.robot_bytes_per_s,
              result.echoes);
  std::printf("  %d comparisons, miscounts %lld, errors %d, echo within %.2f us, stack %d B\n",
              result.comparisons,
              static_cast<long long>(result.miscounts),
              result.encoder_errors,
              result.worst_echo_error_us,
              result.min_stack_bytes);
  return result;
}

class CountsUnderLoad : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

/// 80,000 is beyond what any wheel does.
INSTANTIATE_TEST_SUITE_P(BoardsAndEdgesPerS,
                         CountsUnderLoad,
                         ::testing::Combine(every_board(),
                                            ::testing::Values(20'000, 40'000, 80'000)),
                         [](const auto& test) {
                           return label_of(std::get<0>(test.param)) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST_P(CountsUnderLoad, LosesNoCountNoFrameAndNoMicrosecondInAMinute) {
  const auto [image, edges_per_s] = GetParam();
  const double seconds = edges_per_s > 40'000 ? 10.0 : 61.0;
  const LoadResult result = run_under(image, {.edges_per_s = double(edges_per_s)}, seconds);
  EXPECT_GT(double(result.edges), 2.0 * 0.97 * edges_per_s * seconds);
  EXPECT_GT(result.comparisons, 2.0 * seconds);
  EXPECT_EQ(result.miscounts, 0);
  EXPECT_EQ(result.encoder_errors, 0);
  EXPECT_TRUE(result.under_control) << "the wheels were not under control until the end";
  EXPECT_GT(result.echoes, 4.0 * seconds);
  EXPECT_LE(result.worst_echo_error_us, 1.0);
  EXPECT_EQ(result.frames_bad, 0);
  EXPECT_EQ(result.frames_lost, 0);
  EXPECT_EQ(result.receive_overruns, 0);
  EXPECT_GT(result.host_bytes_per_s, 7'000);
  EXPECT_GT(result.robot_bytes_per_s, 5'000);
  RecordProperty("stack_free_bytes", result.min_stack_bytes);
  EXPECT_GE(result.min_stack_bytes, 300);
  EXPECT_LT(result.min_stack_bytes, 8192) << "nothing was painted";
}

class IllegalSteps : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards,
                         IllegalSteps,
                         ::testing::ValuesIn(images_that_tell_lost_steps()),
                         image_label);
/// None of the boards in this program may have such an encoder.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(IllegalSteps);

TEST_P(IllegalSteps, AreCountedAndToldAndAddNoWay) {
  constexpr int kJumps = 10;
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_FALSE((reply->capabilities & protocol::kCapabilityBlindEncoders) != 0);
  for (int i = 0; i < kJumps; ++i) {
    const bool high = i % 2 == 0;
    for (const auto wheel : {runner::Wheel::kLeft, runner::Wheel::kRight}) {
      robot.board().schedule_encoder_edge(wheel, robot.board().now_ns(), high, high);
      robot.run_ms(2);
    }
  }
  robot.board().schedule_encoder_edge(runner::Wheel::kRight, robot.board().now_ns(), true, true);
  robot.forget_heard();
  robot.run_ms(1100);  // Health comes once a second
  ASSERT_TRUE(robot.last<protocol::Health>());
  EXPECT_EQ(robot.last<protocol::Health>()->encoder_errors, 2 * kJumps + 1);
  ASSERT_TRUE(robot.last<protocol::EncoderErrors>());
  EXPECT_EQ(robot.last<protocol::EncoderErrors>()->left, kJumps);
  EXPECT_EQ(robot.last<protocol::EncoderErrors>()->right, kJumps + 1);
  EXPECT_EQ(robot.last<protocol::Odometry>()->left_ticks, 0);
  EXPECT_EQ(robot.last<protocol::Odometry>()->right_ticks, 0);
}

}  // namespace
}  // namespace echomap::tests
