// SPDX-License-Identifier: MIT
#include "host/tracking/stop_driver.hpp"

#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::tracking {
namespace {

using exploration::FinishReason;

/// Counts scans.
class Scans final : public pipeline::ObservationSink {
 public:
  void on_odometry(const sensors::OdometryObservation& /*observation*/) override {}
  void on_sonar(const sensors::SonarObservation& /*observation*/) override { ++readings; }
  void begin_scan() override {}
  void end_scan() override { ++ended; }

  int readings = 0;
  int ended = 0;
};

/// The fake robot on its cable, which hears nothing unless it is let.
class StopDriverTest : public session::SessionOnACable {
 protected:
  StopDriverTest() {
    robot.fork().add(scans);
    robot.open({new_connection(), nullptr});
    robot.connect();
    driver = std::make_unique<StopDriver>(robot, "multiscan");
  }
  /// `flight_us` of a pan angle.
  void let_it_hear(const std::function<int(int pan_deg)>& flight_us = [](int pan_deg) {
    return 11'655 + 20 * pan_deg;
  }) {
    cable.robot.on_command = [this, flight_us](std::string_view name) {
      for (int pan_deg = -90; name == "StartSweep" && pan_deg < 90; pan_deg += 6) {
        cable.robot.send(protocol::Echo{cable.robot.stamp_us(),
                                        static_cast<std::int16_t>(100 * pan_deg),
                                        static_cast<std::uint16_t>(flight_us(pan_deg)),
                                        0,
                                        0});
      }
    };
  }

  Scans scans;
  session::RobotContext robot{profile, session::Seed(3)};
  std::unique_ptr<StopDriver> driver;
};

TEST_F(StopDriverTest, SweepsTwiceAroundAtAStopAndLooksAroundAsItTurns) {
  let_it_hear();
  EXPECT_TRUE(driver->go_to_next_stop({}));
  EXPECT_EQ(scans.ended, 1);
  EXPECT_EQ(scans.readings, (4 + 1) * 30);
  EXPECT_FALSE(driver->finished());
}

TEST_F(StopDriverTest, EndsWhereTheSonarDoesNotAnswer) {
  let_it_hear([](int) { return protocol::kNoSonar; });
  EXPECT_TRUE(driver->go_to_next_stop({}));
  EXPECT_FALSE(driver->go_to_next_stop({}));
  EXPECT_EQ(driver->finished(), FinishReason::kSonarSilent);
}

TEST_F(StopDriverTest, BeginsANewMapWhereWhatItHearsContradictsItsOwn) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop({}));
  ASSERT_TRUE(driver->go_to_next_stop({}));
  let_it_hear([](int pan_deg) { return 5'000 + 10 * pan_deg; });
  for (int stop = 0; stop < 4; ++stop) {
    ASSERT_TRUE(driver->go_to_next_stop({})) << stop;
  }
  EXPECT_LE(driver->pipeline().snapshot().stops, 4U);
}

TEST_F(StopDriverTest, BeginsANewMapWithTheStopsThatAreOfIt) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop({}));
  driver->begin_new_map(1);
  EXPECT_EQ(driver->pipeline().snapshot().stops, 1U);
  driver->begin_new_map(0);
  EXPECT_EQ(driver->pipeline().snapshot().stops, 0U);
}

TEST_F(StopDriverTest, IsPlacedByTheSlamThatIsNamedAlsoWhereItStartsAnew) {
  EXPECT_NE(driver->pipeline().slam(), nullptr);
  driver = std::make_unique<StopDriver>(robot, "none");
  EXPECT_EQ(driver->pipeline().slam(), nullptr);
  driver->begin_new_map(0);
  EXPECT_EQ(driver->pipeline().slam(), nullptr);
}

TEST_F(StopDriverTest, EndsWithTheSession) {
  cable.time_passes = false;
  EXPECT_FALSE(driver->go_to_next_stop({}));
  EXPECT_FALSE(driver->finished());
}

TEST_F(StopDriverTest, ListensNoMoreOnceItIsGone) {
  driver.reset();
  robot.fork().end_scan();
  EXPECT_EQ(scans.ended, 1);
}

}  // namespace
}  // namespace echomap::tracking
