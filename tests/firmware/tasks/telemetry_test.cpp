// SPDX-License-Identifier: MIT
#include "firmware/tasks/telemetry.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/boards/native/native_board.hpp"
#include "protocol/frame_decoder.hpp"

namespace echomap::tasks {
namespace {

struct Collected {
  std::vector<protocol::Echo> echoes;
  std::vector<protocol::Odometry> odometry;
  std::vector<protocol::Status> status;
  std::vector<protocol::Health> health;
  std::vector<protocol::Ranges> ranges;
  std::vector<protocol::Gyro> gyro;
  std::vector<protocol::EncoderErrors> encoder_errors;
  std::vector<protocol::Scalar> scalar;

  void operator()(const protocol::Echo& message) { echoes.push_back(message); }
  void operator()(const protocol::Odometry& message) { odometry.push_back(message); }
  void operator()(const protocol::Status& message) { status.push_back(message); }
  void operator()(const protocol::Health& message) { health.push_back(message); }
  void operator()(const protocol::Ranges& message) { ranges.push_back(message); }
  void operator()(const protocol::Gyro& message) { gyro.push_back(message); }
  void operator()(const protocol::EncoderErrors& message) { encoder_errors.push_back(message); }
  void operator()(const protocol::Scalar& message) { scalar.push_back(message); }
  template <class Other>
  void operator()(const Other& /*message*/) {}
};

class TelemetryTest : public testing::Test {
 protected:
  /// In which the line's budget looks for losses.
  static constexpr int kWindowMs = 256;

  /// The line has been idle for a while.
  TelemetryTest() {
    boards::start_edge_count(0);
    for (int ms = 0; ms < kWindowMs; ++ms) {
      sender.budget().tick();
    }
  }
  /// Takes every byte that waits on the line.
  Collected collect() {
    Collected collected;
    std::uint8_t byte = 0;
    while (port.on_send_ready(byte)) {
      if (decoder.take(byte) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame frame = decoder.frame();
        protocol::Dispatcher<protocol::MessagesToHost>::dispatch(
            frame.id, frame.payload, collected);
      }
    }
    return collected;
  }
  /// Ticks, and reads the line each time, until the next Health.
  protocol::Health next_health() {
    constexpr int kLongestMs = Telemetry::kStatusPeriodMs * Telemetry::kStatusPerHealth
                               << LineBudget::kMaxRateStep;
    for (int ms = 0; ms < kLongestMs; ++ms) {
      tick(1);
      const Collected now = collect();
      if (!now.health.empty()) {
        return now.health[0];
      }
    }
    ADD_FAILURE() << "no Health";
    return {};
  }
  /// Ticks, and reads the line each time; how many Odometry came.
  int odometry_in(int duration_ms) {
    int odometry = 0;
    for (int ms = 0; ms < duration_ms; ++ms) {
      tick(1);
      odometry += int(collect().odometry.size());
    }
    return odometry;
  }
  void tick(int times) {
    for (int i = 0; i < times; ++i) {
      telemetry.tick();
    }
  }

  drivers::WheelEncoders encoders;
  drivers::Sonar sonar;
  drivers::SerialPort port;
  protocol::Configuration configuration = app::kDefaultConfiguration;
  control::WheelMotion motion{encoders, configuration.drive, configuration.safety};
  Sensors sensors{configuration.pins, configuration.sensors, configuration.scalar};
  drivers::PanDrive pan_drive{configuration.pan, sensors.pins()};
  control::ScanSweep sweep{encoders, sonar, pan_drive, configuration.sonar};
  Safety safety{motion, sensors, configuration.safety, configuration.wiring};
  FrameSender sender{port};
  protocol::ReceiveCounters received;
  Telemetry telemetry{{encoders, port, motion, sweep, sensors, safety, received, configuration},
                      sender};
  protocol::FrameDecoder decoder{protocol::MessagesToHost::find_schema};
};

TEST_F(TelemetryTest, IsSilentUntilAHostIsThere) {
  tick(1000);
  EXPECT_EQ(port.send_room(), drivers::SerialPort::kSendBytes);
  telemetry.begin();
  tick(1);
  EXPECT_EQ(collect().status.size(), 1U);
}

TEST_F(TelemetryTest, KeepsItsPeriods) {
  telemetry.begin();
  std::size_t odometry = 0;
  std::size_t status = 0;
  std::size_t health = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    tick(1);
    const Collected now = collect();
    odometry += now.odometry.size();
    status += now.status.size();
    health += now.health.size();
  }
  EXPECT_EQ(odometry, 50U);
  EXPECT_EQ(status, 1U + 5U);
  EXPECT_EQ(health, 1U + 1U);
  configuration.drive.odometry_period_ms = 5;
  odometry = 0;
  for (int ms = 0; ms < 100; ++ms) {
    tick(1);
    odometry += collect().odometry.size();
  }
  EXPECT_EQ(odometry, 20U);
}

TEST_F(TelemetryTest, ReplacesOdometryThatWaitsTooLongAndCountsIt) {
  telemetry.begin();
  boards::count_edges(0b0001);
  tick(12 * 20);
  const Collected stale = collect();
  boards::count_edges(0b0011);
  ASSERT_FALSE(stale.odometry.empty());
  tick(1);
  const Collected fresh = collect();
  ASSERT_EQ(fresh.odometry.size(), 1U);
  EXPECT_EQ(fresh.odometry[0].left_ticks, 1) << "sampled before the last edge";
  const std::size_t sampled = 12;
  const std::size_t told = stale.odometry.size() + fresh.odometry.size();
  EXPECT_EQ(next_health().telemetry_dropped, sampled - told);
}

TEST_F(TelemetryTest, CountsTheGyroThatWaitsTooLong) {
  configuration.sensors.gyro_period_ms = 10;
  telemetry.begin();
  tick(12 * 20);
  const Collected stale = collect();
  tick(1);
  const Collected fresh = collect();
  const std::size_t told =
      stale.odometry.size() + stale.gyro.size() + fresh.odometry.size() + fresh.gyro.size();
  ASSERT_LT(told, 24U);
  EXPECT_EQ(next_health().telemetry_dropped, 24U - told);
}

TEST_F(TelemetryTest, KeepsTheNewestEchoesAndCountsTheRest) {
  telemetry.begin();
  for (std::int16_t pan = 0; pan < 6; ++pan) {
    telemetry.add(protocol::Echo{0, pan, 0, 0, 0});
  }
  tick(1);
  Collected all = collect();
  tick(1);
  const Collected rest = collect();
  all.echoes.insert(all.echoes.end(), rest.echoes.begin(), rest.echoes.end());
  ASSERT_EQ(all.echoes.size(), 4U);
  EXPECT_EQ(all.echoes[0].pan_cdeg, 2);
  EXPECT_EQ(all.echoes[3].pan_cdeg, 5);
  EXPECT_EQ(next_health().telemetry_dropped, 2);
}

TEST_F(TelemetryTest, RangesComeAtTheirPeriodAndOnlyThen) {
  telemetry.begin();
  std::size_t before = 0;
  std::size_t after = 0;
  for (int ms = 0; ms < 500; ++ms) {
    tick(1);
    before += collect().ranges.size();
  }
  configuration.sensors.ranges_period_ms = 50;
  for (int ms = 0; ms < 510; ++ms) {
    tick(1);
    after += collect().ranges.size();
  }
  EXPECT_EQ(before, 0U);
  EXPECT_EQ(after, 10U);
}

TEST_F(TelemetryTest, ScalarThatWaitsTooLongIsCountedAndItsSumIsOfTheNext) {
  configuration.scalar.period_ms = 20;
  telemetry.begin();
  tick(12 * 20);
  const Collected stale = collect();
  protocol::ConfigurePins pins{};
  pins.pin_3 = protocol::kPinScalarPulses;
  sensors.configure(pins);
  native::NativeBoard::instance().set_aux_level(3, false);
  native::NativeBoard::instance().set_aux_level(3, true);
  sensors.tick();
  tick(1);
  const Collected fresh = collect();
  ASSERT_EQ(fresh.scalar.size(), 1U);
  EXPECT_EQ(fresh.scalar[0].sum, 1U) << "gathered when there is room";
  const std::size_t told = stale.odometry.size() + stale.scalar.size() + fresh.odometry.size() + 1;
  EXPECT_EQ(next_health().telemetry_dropped, 24U - told);
}

TEST_F(TelemetryTest, GyroComesWithEveryOdometryWhileItIsOn) {
  telemetry.begin();
  configuration.sensors.gyro_period_ms = 10;
  Collected all;
  for (int ms = 0; ms < 400; ++ms) {
    tick(1);
    Collected now = collect();
    all.odometry.insert(all.odometry.end(), now.odometry.begin(), now.odometry.end());
    all.gyro.insert(all.gyro.end(), now.gyro.begin(), now.gyro.end());
  }
  EXPECT_EQ(all.odometry.size(), 20U);
  EXPECT_EQ(all.gyro.size(), 20U);
}

TEST_F(TelemetryTest, TellsAHazardAtOnceAndItsEnd) {
  protocol::ConfigurePins pins{};
  pins.pin_11 = protocol::kPinCliffRight;
  sensors.configure(pins);
  telemetry.begin();
  tick(1);
  collect();
  native::NativeBoard::instance().set_aux_level(11, false);
  sensors.tick();
  tick(1);
  const Collected begun = collect();
  native::NativeBoard::instance().set_aux_level(11, true);
  ASSERT_EQ(begun.status.size(), 1U);
  EXPECT_EQ(begun.status[0].hazards, protocol::kHazardCliffRight);
  EXPECT_TRUE((begun.status[0].flags & protocol::kFlagHazard) != 0);
  for (int ms = 0; ms < drivers::DebouncedBits::kMaxReleaseMs; ++ms) {
    sensors.tick();
  }
  tick(1);
  const Collected ended = collect();
  ASSERT_EQ(ended.status.size(), 1U);
  EXPECT_EQ(ended.status[0].hazards, 0);
  EXPECT_FALSE((ended.status[0].flags & protocol::kFlagHazard) != 0);
}

TEST_F(TelemetryTest, TellsAnOutcomeAtOnce) {
  telemetry.begin();
  tick(1);
  collect();
  motion.start_move({7, 100, 100, 100, 0});
  tick(1);
  Collected now = collect();
  ASSERT_EQ(now.status.size(), 1U);
  EXPECT_EQ(now.status[0].move_id, 7);
  EXPECT_EQ(now.status[0].move_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning));
  EXPECT_EQ(now.status[0].flags, protocol::kFlagMoving);
  motion.stop(protocol::MotionOutcome::kBumped);
  tick(1);
  now = collect();
  ASSERT_EQ(now.status.size(), 1U);
  EXPECT_EQ(now.status[0].move_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kBumped));
  tick(1);
  EXPECT_TRUE(collect().status.empty());
}

TEST_F(TelemetryTest, StretchesItsPeriodsWhenTheLineLosesSomething) {
  telemetry.begin();
  configuration.drive.odometry_period_ms = 10;
  EXPECT_EQ(odometry_in(4 * kWindowMs), 102);
  tick(200);  // Nothing leaves the queue.
  collect();
  EXPECT_EQ(sender.budget().rate_step(), 0);
  odometry_in(kWindowMs);
  EXPECT_EQ(sender.budget().rate_step(), 1);
  EXPECT_NEAR(odometry_in(1000), 50, 1);
  EXPECT_EQ(next_health().rate_step, 1);
}

TEST_F(TelemetryTest, ComesBackToItsPeriodsWhenTheLineHasRoom) {
  telemetry.begin();
  for (int i = 0; i < 5; ++i) {
    sender.budget().overloaded();
    odometry_in(kWindowMs);
  }
  ASSERT_EQ(sender.budget().rate_step(), 5);
  EXPECT_NEAR(odometry_in(1280), 2, 1) << "every 640 ms";
  odometry_in(5 * 2500);
  EXPECT_EQ(sender.budget().rate_step(), 0);
  EXPECT_EQ(odometry_in(1000), 50);
}

TEST_F(TelemetryTest, TellsStatusOnlyWhenOdometryDoesNotWait) {
  telemetry.begin();
  tick(1);
  collect();
  while (sender.budget().take(1)) {
  }
  // 8 bytes a millisecond come in; both are due in the same one.
  configuration.drive.odometry_period_ms = 200;
  std::vector<char> order;
  for (int ms = 0; ms < 210; ++ms) {
    while (ms > 190 && ms < 203 && sender.budget().take(1)) {
    }
    tick(1);
    const Collected now = collect();
    order.insert(order.end(), now.odometry.size(), 'o');
    order.insert(order.end(), now.status.size(), 's');
  }
  EXPECT_EQ(order, (std::vector<char>{'o', 's'}));
}

TEST_F(TelemetryTest, CarriesCountsAndErrors) {
  telemetry.begin();
  boards::count_edges(0b0001);
  boards::count_edges(0b0101);
  boards::count_edges(0b1010);
  tick(20);
  const Collected now = collect();
  ASSERT_EQ(now.odometry.size(), 1U);
  EXPECT_EQ(now.odometry[0].left_ticks, 1);
  EXPECT_EQ(now.odometry[0].right_ticks, 1);
  EXPECT_EQ(next_health().encoder_errors, 2);
}

TEST_F(TelemetryTest, TellsTheErrorsOfEachWheelWithEveryHealthOnceThereAreAny) {
  boards::start_edge_count(0);
  telemetry.begin();
  for (int ms = 0; ms < 1200; ++ms) {
    tick(1);
    EXPECT_TRUE(collect().encoder_errors.empty()) << "a clean encoder costs the line nothing";
  }
  boards::count_edges(0b0011);
  boards::count_edges(0b1111);
  boards::count_edges(0b1100);
  std::size_t health = 0;
  std::vector<protocol::EncoderErrors> errors;
  for (int ms = 0; ms < 3000; ++ms) {
    tick(1);
    const Collected now = collect();
    health += now.health.size();
    errors.insert(errors.end(), now.encoder_errors.begin(), now.encoder_errors.end());
    EXPECT_LE(errors.size(), health) << ms;
  }
  EXPECT_EQ(health, 3U);
  ASSERT_EQ(errors.size(), health);
  EXPECT_EQ(errors[0].left, 2);
  EXPECT_EQ(errors[0].right, 1);
}

}  // namespace
}  // namespace echomap::tasks
