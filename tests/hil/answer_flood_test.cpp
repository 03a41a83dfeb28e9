// SPDX-License-Identifier: MIT
/// Hosts that ask for answers without a pause.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

constexpr int kMs = 2000;
constexpr int kOdometryPeriodMs = 10;

/// Of an image with this name.
int bytes_per_ms(const std::string& image) {
  const auto dash = image.find_last_of('-');
  const std::string suffix = image.substr(dash + 1);
  const bool has_baud = suffix.find_first_not_of("0123456789") == std::string::npos;
  return (has_baud ? std::stoi(suffix) : 250000) / 10'000;
}

class AnswerFlood : public OnEveryBoard {
 protected:
  /// Fills the robot's receive line with a message for a while; the share of the odometry that is
  /// due, at its stretched period, which comes all the same.
  template <class M>
  double odometry_share(const M& message) {
    EXPECT_TRUE(robot.connect());
    const protocol::ConfigureDrive drive{0, 0, 3000, 6000, 20, 30, 300, kOdometryPeriodMs};
    EXPECT_EQ(robot.command(drive), protocol::CommandStatus::kAccepted);
    int owed = 0;
    robot.each_ms = [&] {
      for (owed += bytes_per_ms(GetParam()); owed > 0;
           owed -= protocol::kFrameOverhead + protocol::MessageFacts<M>::kSize) {
        robot.send(message);
      }
    };
    robot.run_ms(500);
    robot.forget_heard();
    robot.run_ms(kMs);
    const auto health = robot.last<protocol::Health>();
    const int period_ms = kOdometryPeriodMs << (health ? health->rate_step : 0);
    const auto came = robot.all<protocol::Odometry>().size();
    std::printf("every %d ms: %zu odometry, %zu pongs, %zu acks, %zu replies in %d ms\n",
                period_ms,
                came,
                robot.all<protocol::Pong>().size(),
                robot.all<protocol::Ack>().size(),
                robot.all<protocol::HelloReply>().size(),
                kMs);
    return double(came) * period_ms / kMs;
  }
};

INSTANTIATE_TEST_SUITE_P(Boards, AnswerFlood, every_image(), image_label);

TEST_P(AnswerFlood, OfPingsLeavesOdometryItsPlace) {
  EXPECT_GE(odometry_share(protocol::Ping{1}), 0.9);
}

TEST_P(AnswerFlood, OfCommandsLeavesOdometryItsPlace) {
  EXPECT_GE(odometry_share(protocol::Stop{77}), 0.9);
}

TEST_P(AnswerFlood, OfForeignHellosLeavesOdometryItsPlace) {
  EXPECT_GE(odometry_share(protocol::Hello{1, 3, 0, 99}), 0.9);
}

}  // namespace
}  // namespace echomap::tests
