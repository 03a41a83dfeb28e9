// SPDX-License-Identifier: MIT
#include "host/tracking/stop_driver.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
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
  explicit StopDriverTest(double pan_limit_rad = 0.5 * std::numbers::pi)
      : robot(panning(profile, pan_limit_rad), session::Seed(3)) {
    may_be_lifted = true;
    robot.fork().add(scans);
    robot.open({new_connection(), nullptr});
    robot.connect();
    driver = new_driver("multiscan");
  }
  std::unique_ptr<StopDriver> new_driver(const std::string& slam) {
    return std::make_unique<StopDriver>(robot, slam, [](const geometry::Pose2&) { return 0.0; });
  }
  /// `flight_us` of a pan angle.
  void let_it_hear(const std::function<int(int pan_deg)>& flight_us = [](int pan_deg) {
    return 11'655 + 20 * pan_deg;
  }) {
    cable.robot.on_command = [this, flight_us](std::string_view name) {
      cable.robot.answer = refuses_moves && name == "MoveTicks"
                               ? protocol::CommandStatus::kBlocked
                               : protocol::CommandStatus::kAccepted;
      const int limit_deg = static_cast<int>(geometry::degrees(profile.pan_limit_rad));
      for (int pan_deg = -limit_deg; name == "StartSweep" && pan_deg < limit_deg; pan_deg += 6) {
        cable.robot.send(protocol::Echo{cable.robot.stamp_us(),
                                        static_cast<std::int16_t>(100 * pan_deg),
                                        static_cast<std::uint16_t>(flight_us(pan_deg)),
                                        0,
                                        0});
      }
    };
  }

  static session::RobotProfile& panning(session::RobotProfile& profile, double limit_rad) {
    profile.pan_limit_rad = limit_rad;
    return profile;
  }

  bool refuses_moves = false;
  Scans scans;
  session::RobotContext robot;
  std::unique_ptr<StopDriver> driver;
};

TEST_F(StopDriverTest, SweepsTwiceAroundAtAStopAndLooksAroundAsItTurns) {
  let_it_hear();
  EXPECT_TRUE(driver->go_to_next_stop());
  EXPECT_EQ(scans.ended, 1);
  EXPECT_EQ(scans.readings, (4 + 1) * 30);
  EXPECT_FALSE(driver->finished());
}

TEST_F(StopDriverTest, EndsWhereTheSonarDoesNotAnswer) {
  let_it_hear([](int) { return protocol::kNoSonar; });
  EXPECT_TRUE(driver->go_to_next_stop());
  EXPECT_FALSE(driver->go_to_next_stop());
  EXPECT_EQ(driver->finished(), FinishReason::kSonarSilent);
}

TEST_F(StopDriverTest, BeginsANewMapWhereWhatItHearsContradictsItsOwn) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop());
  ASSERT_TRUE(driver->go_to_next_stop());
  let_it_hear([](int pan_deg) { return 5'000 + 10 * pan_deg; });
  for (int stop = 0; stop < 4; ++stop) {
    ASSERT_TRUE(driver->go_to_next_stop()) << stop;
  }
  EXPECT_LE(driver->pipeline().snapshot().stops, 4U);
}

/// One whose sonar pans all round.
class AllRoundStopDriverTest : public StopDriverTest {
 protected:
  AllRoundStopDriverTest() : StopDriverTest(std::numbers::pi) {}
};

TEST_F(AllRoundStopDriverTest, TriesANewMapOnTheSpotBeforeItKnowsNowhereToGo) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop());
  refuses_moves = true;
  EXPECT_TRUE(driver->go_to_next_stop());
  EXPECT_EQ(driver->pipeline().snapshot().stops, 1U) << "a new map";
  EXPECT_FALSE(driver->go_to_next_stop());
  EXPECT_EQ(driver->finished(), FinishReason::kNowhereToGo);
}

TEST_F(StopDriverTest, BeginsANewMapWithTheStopsThatAreOfIt) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop());
  driver->begin_new_map(1);
  EXPECT_EQ(driver->pipeline().snapshot().stops, 1U);
  driver->begin_new_map(0);
  EXPECT_EQ(driver->pipeline().snapshot().stops, 0U);
}

TEST_F(StopDriverTest, BeginsANewMapWhereItIsPutDown) {
  let_it_hear();
  ASSERT_TRUE(driver->go_to_next_stop());
  cable.robot.hazards = protocol::kHazardWheelDrop;
  robot.session().wait_until([] { return false; }, std::chrono::milliseconds(600));
  cable.robot.hazards = 0;
  ASSERT_TRUE(driver->go_to_next_stop());
  EXPECT_EQ(driver->pipeline().snapshot().stops, 1U);
  driver->begin_new_map(1);
  EXPECT_EQ(driver->pipeline().snapshot().stops, 1U) << "heard where it was put down";
}

TEST_F(StopDriverTest, IsPlacedByTheSlamThatIsNamedAlsoWhereItStartsAnew) {
  EXPECT_NE(driver->pipeline().slam(), nullptr);
  driver = new_driver("none");
  EXPECT_EQ(driver->pipeline().slam(), nullptr);
  driver->begin_new_map(0);
  EXPECT_EQ(driver->pipeline().slam(), nullptr);
}

TEST_F(StopDriverTest, EndsWithTheSession) {
  cable.time_passes = false;
  EXPECT_FALSE(driver->go_to_next_stop());
  EXPECT_FALSE(driver->finished());
}

TEST_F(StopDriverTest, ListensNoMoreOnceItIsGone) {
  driver.reset();
  robot.fork().end_scan();
  EXPECT_EQ(scans.ended, 1);
}

}  // namespace
}  // namespace echomap::tracking
