// SPDX-License-Identifier: MIT
#include "firmware/control/scan_sweep.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/boards/native/native_board.hpp"

namespace echomap::control {
namespace {

using protocol::MotionOutcome;

/// Time on the native board; the echo edges go to a sonar of the test's own.
class ScanSweepTest : public testing::Test {
 protected:
  ScanSweepTest() {
    board.power_on();
    board.on_trigger = [this](std::int64_t at_ns) {
      pings_ms.push_back(at_ns / 1000000);
      if (answers) {
        sonar.on_echo_edge(true, static_cast<std::uint32_t>(at_ns / 500) + 920);
        sonar.on_echo_edge(false, static_cast<std::uint32_t>(at_ns / 500) + 920 + 2 * 3000);
      }
    };
  }
  ~ScanSweepTest() override { board.on_trigger = nullptr; }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      board.run_until_ns(board.now_ns() + 1000000);
      protocol::Echo echo{};
      if (sweep.tick(echo)) {
        echoes.push_back(echo);
      }
    }
  }
  std::vector<int> pans() const {
    std::vector<int> pans;
    for (const protocol::Echo& echo : echoes) {
      pans.push_back(echo.pan_cdeg);
    }
    return pans;
  }

  native::NativeBoard& board = native::NativeBoard::instance();
  drivers::WheelEncoders encoders;
  drivers::Sonar sonar;
  protocol::Configuration configuration = app::kDefaultConfiguration;
  drivers::SparePins pins{configuration.pins};
  drivers::PanDrive pan{configuration.pan, pins};
  ScanSweep sweep{encoders, sonar, pan, configuration.sonar};
  std::vector<protocol::Echo> echoes;
  std::vector<std::int64_t> pings_ms;
  bool answers = true;
};

TEST_F(ScanSweepTest, ReadsEveryPanUpToAndIncludingTheLast) {
  sweep.start({5, -9000, 9000, 600, 40});
  EXPECT_EQ(sweep.report().outcome, MotionOutcome::kRunning);
  run_ms(10000);
  ASSERT_EQ(echoes.size(), 31U);
  for (int i = 0; i < 31; ++i) {
    EXPECT_EQ(pans()[static_cast<std::size_t>(i)], -9000 + 600 * i);
    EXPECT_EQ(echoes[static_cast<std::size_t>(i)].flight_us, 3000);
  }
  EXPECT_EQ(sweep.report().outcome, MotionOutcome::kReached);
  EXPECT_EQ(sweep.report().id, 5);
}

TEST_F(ScanSweepTest, GoesBackwardsAndStopsBeforeAnEndThatIsNoStep) {
  sweep.start({5, 100, -250, -150, 0});
  run_ms(3000);
  EXPECT_EQ(pans(), (std::vector<int>{100, -50, -200}));
}

TEST_F(ScanSweepTest, OnePanIsOneReading) {
  sweep.start({5, 300, 300, 0, 0});
  run_ms(2000);
  EXPECT_EQ(pans(), (std::vector<int>{300}));
  EXPECT_FALSE(sweep.sweeping());
}

TEST_F(ScanSweepTest, WaitsForTravelFrameAndSettling) {
  sweep.start({5, 0, 6000, 6000, 30});
  run_ms(2000);
  ASSERT_EQ(pings_ms.size(), 2U);
  EXPECT_EQ(pings_ms[0], 600 + 30 + 20);  // From anywhere within 180 degrees at 300 a second.
  const std::int64_t heard_ms = echoes[0].stamp_us / 1000 + 1;
  EXPECT_EQ(pings_ms[1] - heard_ms, 200 + 30 + 20);
}

TEST_F(ScanSweepTest, KeepsTheGapBetweenPings) {
  protocol::ConfigureSonar settings = app::kDefaultSonar;
  settings.ping_gap_ms = 150;
  sweep.configure(settings);
  sweep.start({5, 0, 1000, 100, 0});
  run_ms(4000);
  ASSERT_EQ(pings_ms.size(), 11U);
  for (std::size_t i = 1; i < pings_ms.size(); ++i) {
    EXPECT_GE(pings_ms[i] - pings_ms[i - 1], 150);
    EXPECT_LE(pings_ms[i] - pings_ms[i - 1], 152);
  }
}

TEST_F(ScanSweepTest, ReadingThatTheSonarDoesNotAnswerDoesNotHoldItUp) {
  answers = false;
  sweep.start({5, 0, 300, 100, 0});
  run_ms(3000);
  ASSERT_EQ(echoes.size(), 4U);
  EXPECT_EQ(echoes[3].flight_us, protocol::kNoSonar);
  EXPECT_EQ(sweep.report().outcome, MotionOutcome::kReached);
}

TEST_F(ScanSweepTest, EchoPinStuckHighCountsAsNoSonar) {
  answers = false;
  board.schedule_echo(1000000, 1000000000000);
  sweep.start({5, 0, 100, 100, 0});
  run_ms(5000);
  ASSERT_EQ(echoes.size(), 2U);
  EXPECT_EQ(echoes[1].flight_us, protocol::kNoSonar);
}

TEST_F(ScanSweepTest, NoFlightTimeIsTakenForOneOfTheCodes) {
  EXPECT_TRUE(ScanSweep::accepts(protocol::ConfigureSonar{1, protocol::kNoSonar - 1, 40}));
  EXPECT_FALSE(ScanSweep::accepts(protocol::ConfigureSonar{1, protocol::kNoSonar, 40}));
  EXPECT_FALSE(ScanSweep::accepts(protocol::ConfigureSonar{1, protocol::kNoEcho, 40}));
}

TEST_F(ScanSweepTest, EchoCarriesTheCountsAndTheTimeOfItsPing) {
  for (const int levels : {0b0001, 0b0011, 0b0111}) {
    boards::count_edges(static_cast<std::uint8_t>(levels));
  }
  boards::fold_edges();
  sweep.start({5, 0, 0, 0, 0});
  run_ms(2000);
  ASSERT_EQ(echoes.size(), 1U);
  EXPECT_EQ(echoes[0].left_ticks, 2);
  EXPECT_EQ(echoes[0].right_ticks, 1);
  EXPECT_EQ(echoes[0].stamp_us, pings_ms[0] * 1000);
}

TEST_F(ScanSweepTest, StopDropsTheReadingUnderWay) {
  sweep.start({5, 0, 1000, 100, 0});
  run_ms(100);
  sweep.stop(MotionOutcome::kStopped);
  const std::size_t before = echoes.size();
  run_ms(1000);
  EXPECT_EQ(echoes.size(), before);
  EXPECT_EQ(sweep.report().outcome, MotionOutcome::kStopped);
}

TEST_F(ScanSweepTest, KnowsNotWhereItStandsAfterAStopInMidTurn) {
  sweep.start({5, -9000, -9000, 0, 0});
  run_ms(2000);
  sweep.start({6, 9000, 9000, 0, 0});
  run_ms(10);
  sweep.stop(MotionOutcome::kStopped);
  pings_ms.clear();
  const std::int64_t start_ms = board.now_ns() / 1000000;
  sweep.start({7, 9000, 9000, 0, 0});
  run_ms(2000);
  ASSERT_EQ(pings_ms.size(), 1U);
  EXPECT_GE(pings_ms[0] - start_ms, 600) << "180 degrees at 300 degrees/s";
}

TEST_F(ScanSweepTest, RefusesSweepsThatLeadNowhere) {
  const auto accepts = [&](int from, int to, int step) {
    return sweep.accepts(protocol::StartSweep{1,
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
