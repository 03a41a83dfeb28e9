// SPDX-License-Identifier: MIT
/// What the release images put on their lines, byte by byte, and how long answers take there.
#include <algorithm>
#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

/// The Uno's image for a baud rate; every ping is answered after 3 ms.
class LineLoad {
 public:
  explicit LineLoad(const std::string& image) : robot(release_image(image)) {
    robot.board().on_trigger = [this](std::int64_t at_ns) {
      robot.board().schedule_echo(at_ns + 460'000, at_ns + 3'460'000);
    };
  }

  void ask_odometry(std::uint8_t period_ms) {
    const protocol::ConfigureDrive drive{0, 0, 3000, 6000, 20, 30, 300, period_ms};
    ASSERT_EQ(robot.command(drive), CommandStatus::kAccepted);
  }
  /// Sweeps over the whole half turn with at least `ping_gap_ms` from one ping to the next.
  void sweep(std::uint8_t ping_gap_ms, std::int32_t step_cdeg) {
    ASSERT_EQ(robot.command(protocol::ConfigureSonar{0, 24'000, ping_gap_ms}),
              CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(protocol::StartSweep{0, -9000, 9000, step_cdeg, 0}),
              CommandStatus::kAccepted);
  }
  /// Bytes a second over some seconds in which nobody asks anything.
  double bytes_per_s(int seconds) {
    robot.forget_heard();
    const std::size_t before = robot.bytes().size();
    robot.run_ms(seconds * 1000);
    return double(robot.bytes().size() - before) / seconds;
  }
  template <class M>
  double per_s(int seconds) {
    return double(robot.all<M>().size()) / seconds;
  }
  int rate_step() { return robot.last<protocol::Health>().value().rate_step; }
  int dropped() { return robot.last<protocol::Health>().value().telemetry_dropped; }

  RobotSession robot;
};

TEST(LineLoad, ASlowLineIsAskedForTooMuchAndFallsBackToWhatFits) {
  constexpr int kSeconds = 30;
  LineLoad line("echomap-uno-9600");
  ASSERT_TRUE(line.robot.connect());
  line.ask_odometry(10);
  line.robot.run_ms(5000);
  const int dropped_before = line.dropped();
  const double bytes_per_s = line.bytes_per_s(kSeconds);
  std::printf(
      "9600 baud, odometry every 10 ms asked: step %d, %.1f of 960 B/s, %.1f odometry/s, "
      "%.1f Status/s, %.2f Health/s\n",
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

TEST(LineLoad, ASlowLineAnswersAtOnceAndBringsEveryEcho) {
  constexpr std::int64_t kMs = 1'000'000;
  LineLoad line("echomap-uno-9600");
  ASSERT_TRUE(line.robot.connect());
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
  ASSERT_NO_FATAL_FAILURE(line.sweep(40, 600));
  line.robot.forget_heard();
  line.robot.run_ms(5000);
  EXPECT_EQ(line.robot.all<protocol::Echo>().size(), 31U);
  EXPECT_EQ(line.robot.last<protocol::Status>()->sweep_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kReached));
  EXPECT_EQ(line.robot.counters().frames_lost(), 0);
}

TEST(LineLoad, ASlowLineTakesTwentyOfOdometryAndOfEchoesASecond) {
  constexpr int kSeconds = 12;
  constexpr int kFrameAtTheEdge = 25;  // The end of one that began before: of a Health at most.
  LineLoad line("echomap-uno-9600");
  ASSERT_TRUE(line.robot.connect());
  line.ask_odometry(50);
  line.robot.run_ms(5000);
  ASSERT_NO_FATAL_FAILURE(line.sweep(50, 50));
  line.robot.run_ms(3000);  // The burst that the idle line had saved up is over.
  const int dropped_before = line.dropped();
  const double bytes_per_s = line.bytes_per_s(kSeconds);
  std::printf(
      "9600 baud, sweep and odometry every 50 ms: %.1f of 960 B/s, %.1f odometry/s, "
      "%.1f echoes/s, %.1f Status/s\n",
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

TEST(LineLoad, AUsualLineBringsEverythingInLessThanAFifthOfItself) {
  constexpr int kSeconds = 8;
  LineLoad line("echomap-uno");
  ASSERT_TRUE(line.robot.connect());
  line.ask_odometry(10);
  ASSERT_NO_FATAL_FAILURE(line.sweep(40, 72));
  line.robot.run_ms(1000);
  const double bytes_per_s = line.bytes_per_s(kSeconds);
  const double share = bytes_per_s / 11'520;
  std::printf("115200 baud: %.0f B/s, %.2f %%; %.1f odometry/s, %.1f echoes/s, %.1f Status/s\n",
              bytes_per_s,
              100.0 * share,
              line.per_s<protocol::Odometry>(kSeconds),
              line.per_s<protocol::Echo>(kSeconds),
              line.per_s<protocol::Status>(kSeconds));
  RecordProperty("line_load_percent_115200", std::to_string(100.0 * share));
  EXPECT_LE(share, 0.18);
  EXPECT_NEAR(line.per_s<protocol::Odometry>(kSeconds), 100.0, 0.5);
  EXPECT_GE(line.per_s<protocol::Echo>(kSeconds), 24.0);
  EXPECT_NEAR(line.per_s<protocol::Status>(kSeconds), 5.0, 0.3);
  EXPECT_EQ(line.rate_step(), 0);
  EXPECT_EQ(line.dropped(), 0);
}

}  // namespace
}  // namespace echomap::tests
