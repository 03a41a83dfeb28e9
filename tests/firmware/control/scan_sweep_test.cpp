// SPDX-License-Identifier: MIT
#include "firmware/control/scan_sweep.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/native/native_board.hpp"

namespace echomap::control {
namespace {

using protocol::MotionOutcome;

/// Time on the native board; the echo edges go to a sonar of the test's own.
class ScanSweepTest : public testing::Test {
 protected:
  ScanSweepTest() {
    board_.power_on();
    board_.on_trigger = [this](std::int64_t at_ns) {
      pings_ms_.push_back(at_ns / 1000000);
      if (answers_) {
        sonar_.on_echo_edge(true, static_cast<std::uint32_t>(at_ns / 500) + 920);
        sonar_.on_echo_edge(false, static_cast<std::uint32_t>(at_ns / 500) + 920 + 2 * 3000);
      }
    };
  }
  ~ScanSweepTest() override { board_.on_trigger = nullptr; }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      board_.run_until_ns(board_.now_ns() + 1000000);
      protocol::Echo echo{};
      if (sweep_.tick(echo)) {
        echoes_.push_back(echo);
      }
    }
  }
  std::vector<int> pans() const {
    std::vector<int> pans;
    for (const protocol::Echo& echo : echoes_) {
      pans.push_back(echo.pan_cdeg);
    }
    return pans;
  }

  native::NativeBoard& board_ = native::NativeBoard::instance();
  drivers::WheelEncoders encoders_;
  drivers::SonarHcSr04 sonar_;
  ScanSweep sweep_{encoders_, sonar_, app::kDefaultSonar};
  std::vector<protocol::Echo> echoes_;
  std::vector<std::int64_t> pings_ms_;
  bool answers_ = true;
};

TEST_F(ScanSweepTest, ReadsEveryPanUpToAndIncludingTheLast) {
  sweep_.start({5, -9000, 9000, 600, 40});
  EXPECT_EQ(sweep_.report().outcome, MotionOutcome::kRunning);
  run_ms(10000);
  ASSERT_EQ(echoes_.size(), 31U);
  for (int i = 0; i < 31; ++i) {
    EXPECT_EQ(pans()[static_cast<std::size_t>(i)], -9000 + 600 * i);
    EXPECT_EQ(echoes_[static_cast<std::size_t>(i)].flight_us, 3000);
  }
  EXPECT_EQ(sweep_.report().outcome, MotionOutcome::kReached);
  EXPECT_EQ(sweep_.report().id, 5);
}

TEST_F(ScanSweepTest, GoesBackwardsAndStopsBeforeAnEndThatIsNoStep) {
  sweep_.start({5, 100, -250, -150, 0});
  run_ms(3000);
  EXPECT_EQ(pans(), (std::vector<int>{100, -50, -200}));
}

TEST_F(ScanSweepTest, OnePanIsOneReading) {
  sweep_.start({5, 300, 300, 0, 0});
  run_ms(2000);
  EXPECT_EQ(pans(), (std::vector<int>{300}));
  EXPECT_FALSE(sweep_.sweeping());
}

TEST_F(ScanSweepTest, WaitsForTravelFrameAndSettling) {
  sweep_.start({5, 0, 6000, 6000, 30});
  run_ms(2000);
  ASSERT_EQ(pings_ms_.size(), 2U);
  EXPECT_EQ(pings_ms_[0], 600 + 30 + 20);  // From anywhere within 180 degrees at 300 a second.
  const std::int64_t heard_ms = echoes_[0].stamp_us / 1000 + 1;
  EXPECT_EQ(pings_ms_[1] - heard_ms, 200 + 30 + 20);
}

TEST_F(ScanSweepTest, KeepsTheGapBetweenPings) {
  protocol::ConfigureSonar settings = app::kDefaultSonar;
  settings.ping_gap_ms = 150;
  sweep_.configure(settings);
  sweep_.start({5, 0, 1000, 100, 0});
  run_ms(4000);
  ASSERT_EQ(pings_ms_.size(), 11U);
  for (std::size_t i = 1; i < pings_ms_.size(); ++i) {
    EXPECT_GE(pings_ms_[i] - pings_ms_[i - 1], 150);
    EXPECT_LE(pings_ms_[i] - pings_ms_[i - 1], 152);
  }
}

TEST_F(ScanSweepTest, ReadingWithoutEchoDoesNotHoldItUp) {
  answers_ = false;
  sweep_.start({5, 0, 300, 100, 0});
  run_ms(3000);
  ASSERT_EQ(echoes_.size(), 4U);
  EXPECT_EQ(echoes_[3].flight_us, protocol::kNoEcho);
  EXPECT_EQ(sweep_.report().outcome, MotionOutcome::kReached);
}

TEST_F(ScanSweepTest, EchoPinStuckHighCountsAsNoEcho) {
  answers_ = false;
  board_.schedule_echo(1000000, 1000000000000);
  sweep_.start({5, 0, 100, 100, 0});
  run_ms(5000);
  ASSERT_EQ(echoes_.size(), 2U);
  EXPECT_EQ(echoes_[1].flight_us, protocol::kNoEcho);
}

TEST_F(ScanSweepTest, EchoCarriesTheCountsAndTheTimeOfItsPing) {
  for (const int levels : {0b0001, 0b0011, 0b0111}) {
    encoders_.on_pins(static_cast<std::uint8_t>(levels));
  }
  sweep_.start({5, 0, 0, 0, 0});
  run_ms(2000);
  ASSERT_EQ(echoes_.size(), 1U);
  EXPECT_EQ(echoes_[0].left_ticks, 2);
  EXPECT_EQ(echoes_[0].right_ticks, 1);
  EXPECT_EQ(echoes_[0].stamp_us, pings_ms_[0] * 1000);
}

TEST_F(ScanSweepTest, StopDropsTheReadingUnderWay) {
  sweep_.start({5, 0, 1000, 100, 0});
  run_ms(100);
  sweep_.stop(MotionOutcome::kStopped);
  const std::size_t before = echoes_.size();
  run_ms(1000);
  EXPECT_EQ(echoes_.size(), before);
  EXPECT_EQ(sweep_.report().outcome, MotionOutcome::kStopped);
}

TEST_F(ScanSweepTest, RefusesSweepsThatLeadNowhere) {
  const auto accepts = [&](int from, int to, int step) {
    return sweep_.accepts(protocol::StartSweep{1,
                                               static_cast<std::int16_t>(from),
                                               static_cast<std::int16_t>(to),
                                               static_cast<std::int16_t>(step),
                                               0});
  };
  EXPECT_TRUE(accepts(-9000, 9000, 600));
  EXPECT_TRUE(accepts(9000, -9000, -600));
  EXPECT_FALSE(accepts(-9000, 9000, -600));
  EXPECT_FALSE(accepts(9000, -9000, 600));
  EXPECT_FALSE(accepts(-9000, 9000, 0));
  EXPECT_FALSE(accepts(-9001, 9000, 600));
  EXPECT_FALSE(accepts(0, 9001, 600));
}

}  // namespace
}  // namespace echomap::control
