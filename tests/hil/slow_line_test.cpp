// SPDX-License-Identifier: MIT
/// The Uno's image for 9600 baud: what it puts on its line, and how long answers take there.
#include <algorithm>
#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/hil/measure/line_load.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

TEST(SlowLine, IsAskedForTooMuchAndFallsBackToWhatFits) {
  constexpr int kSeconds = 30;
  LineLoad line(release_image("echomap-uno-9600"));
  line.ask_odometry(10);
  line.robot.run_ms(5000);
  const int dropped_before = line.dropped();
  const double bytes_per_s = line.bytes_per_s(kSeconds);
  std::printf(
      "9600 baud, odometry every 10 ms asked: step %d, %.1f of 960 B/s, %.1f odometry/s, %.1f "
      "Status/s, %.2f Health/s\n",
      line.rate_step(),
      bytes_per_s,
      line.per_s<protocol::Odometry>(kSeconds),
      line.per_s<protocol::Status>(kSeconds),
      line.per_s<protocol::Health>(kSeconds));
  EXPECT_LE(bytes_per_s, 0.70 * 960);
  EXPECT_EQ(line.rate_step(), 2);
  EXPECT_NEAR(line.per_s<protocol::Odometry>(kSeconds), 25.0, 0.1);
  EXPECT_NEAR(line.per_s<protocol::Status>(kSeconds), 1.25, 0.1);
  EXPECT_GE(line.per_s<protocol::Health>(kSeconds), 0.2);
  EXPECT_EQ(line.dropped(), dropped_before) << "what is left fits";
}

TEST(SlowLine, AnswersAtOnceAndBringsEveryEcho) {
  LineLoad line(release_image("echomap-uno-9600"));
  line.ask_odometry(10);
  line.robot.run_ms(3000);
  std::int64_t worst_ns = 0;
  for (int i = 0; i < 50; ++i) {
    const std::int64_t asked_ns = line.robot.board().now_ns();
    ASSERT_EQ(line.robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
    worst_ns = std::max(worst_ns, line.robot.board().now_ns() - asked_ns);
    line.robot.run_ms(37);
  }
  std::printf("9600 baud, odometry every 10 ms asked: Ack after %.1f ms at most\n",
              double(worst_ns) / kMs);
  EXPECT_LE(worst_ns, 90 * kMs);
  line.sweep(40, 600);
  line.robot.forget_heard();
  line.robot.run_ms(5000);
  EXPECT_EQ(line.robot.all<protocol::Echo>().size(), 31U);
  EXPECT_EQ(line.robot.last<protocol::Status>()->sweep_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kReached));
  EXPECT_EQ(line.robot.counters().frames_lost(), 0);
}

TEST(SlowLine, TakesTwentyOfOdometryAndOfEchoesASecond) {
  constexpr int kSeconds = 12;
  constexpr int kFrameAtTheEdge = 25;  // The end of one that began before: of a Health at most.
  LineLoad line(release_image("echomap-uno-9600"));
  line.ask_odometry(50);
  line.robot.run_ms(5000);
  line.sweep(50, 50);
  line.robot.run_ms(3000);  // The burst that the idle line had saved up is over.
  const int dropped_before = line.dropped();
  const double bytes_per_s = line.bytes_per_s(kSeconds);
  std::printf(
      "9600 baud, sweep and odometry every 50 ms: %.1f of 960 B/s, %.1f odometry/s, %.1f echoes/s, "
      "%.1f Status/s\n",
      bytes_per_s,
      line.per_s<protocol::Odometry>(kSeconds),
      line.per_s<protocol::Echo>(kSeconds),
      line.per_s<protocol::Status>(kSeconds));
  EXPECT_LE(kSeconds * bytes_per_s, kSeconds * 0.70 * 960 + kFrameAtTheEdge);
  EXPECT_NEAR(line.per_s<protocol::Odometry>(kSeconds), 20.0, 0.2);
  EXPECT_GE(line.per_s<protocol::Echo>(kSeconds), 19.0);
  EXPECT_GE(line.per_s<protocol::Status>(kSeconds), 0.25);
  EXPECT_EQ(line.rate_step(), 0);
  EXPECT_EQ(line.dropped(), dropped_before);
}

}  // namespace
}  // namespace echomap::tests
