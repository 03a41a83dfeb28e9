// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

class Sweep : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards, Sweep, every_board(), image_label);

TEST_P(Sweep, PansByTheServoPulseAndReadsOnceAtEach) {
  ASSERT_TRUE(robot.connect());
  std::vector<double> pulses_us;
  std::vector<std::int64_t> widths_us;
  robot.board().on_trigger = [&](std::int64_t at_ns) {
    pulses_us.push_back(robot.board().pan_pulse_us());
    widths_us.push_back(500 + 1500 * std::int64_t(widths_us.size()));
    const std::int64_t rise_ns = at_ns + 460'000;
    robot.board().schedule_echo(rise_ns, rise_ns + widths_us.back() * 1000);
  };
  ASSERT_EQ(robot.command(protocol::StartSweep{0, -9000, 9000, 1800, 50}),
            CommandStatus::kAccepted);
  robot.run_ms(3000);
  const std::vector<protocol::Echo> echoes = robot.all<protocol::Echo>();
  ASSERT_EQ(echoes.size(), 11U);
  ASSERT_EQ(pulses_us.size(), 11U);
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    const int pan_cdeg = -9000 + 1800 * int(i);
    EXPECT_EQ(echoes[i].pan_cdeg, pan_cdeg);
    EXPECT_NEAR(pulses_us[i], 1500.0 + pan_cdeg / 10.0, 1.0);
    EXPECT_NEAR(double(echoes[i].flight_us), double(widths_us[i]), 1.0);
  }
  const auto status = robot.last<protocol::Status>();
  EXPECT_EQ(status->sweep_outcome, static_cast<std::uint8_t>(protocol::MotionOutcome::kReached));
  EXPECT_EQ(status->sweep_id, robot.last_command_id());
}

TEST_P(Sweep, SilenceIsNoEchoAndTheNextPingIsHeard) {
  ASSERT_TRUE(robot.connect());
  int pings = 0;
  robot.board().on_trigger = [&](std::int64_t at_ns) {
    const bool silent = pings++ % 2 == 0;
    const std::int64_t rise_ns = at_ns + 460'000;
    robot.board().schedule_echo(rise_ns, rise_ns + (silent ? 38'000'000 : 5'000'000));
  };
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 3000, 1000, 0}), CommandStatus::kAccepted);
  robot.run_ms(2000);
  const std::vector<protocol::Echo> echoes = robot.all<protocol::Echo>();
  ASSERT_EQ(echoes.size(), 4U);
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    if (i % 2 == 0) {
      EXPECT_EQ(echoes[i].flight_us, protocol::kNoEcho);
    } else {
      EXPECT_NEAR(echoes[i].flight_us, 5000, 1);
    }
  }
}

TEST_P(Sweep, SonarThatNeverAnswersEndsTheSweepToo) {
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 3000, 1000, 0}), CommandStatus::kAccepted);
  robot.run_ms(3000);
  const std::vector<protocol::Echo> echoes = robot.all<protocol::Echo>();
  ASSERT_EQ(echoes.size(), 4U);
  for (const protocol::Echo& echo : echoes) {
    EXPECT_EQ(echo.flight_us, protocol::kNoSonar);
  }
}

}  // namespace
}  // namespace echomap::tests
