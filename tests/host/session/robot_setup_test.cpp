// SPDX-License-Identifier: MIT
#include "host/session/robot_setup.hpp"

#include <string>

#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "protocol/config_digest.hpp"
#include "tests/host/robot_link/other_messages.hpp"
#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::session {
namespace {

/// How a session sets its robot up.
class RobotSetupTest : public SessionOnACable {
 protected:
  /// Of a link that ends while the robot is set up.
  std::string reason_of_failure() {
    try {
      session->connect();
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), console::ExitCode::kLinkLost);
      return error.what();
    }
    return "no error";
  }
};

TEST_F(RobotSetupTest, BeginsSettingUpAnewWhenTheBoardIsResetInItsMidst) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "ConfigureSonar" && restarts == 0) {
      power_cycle();
    }
  };
  session->connect();
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(protocol::config_digest(cable.robot.configuration),
            protocol::config_digest(profile.configuration))
      << "the board kept some of its defaults";
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSetupTest, GivesUpOnABoardThatIsResetAgainAndAgain) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "Arm") {
      power_cycle();
    }
  };
  EXPECT_NE(reason_of_failure().find("again and again: 5 times"), std::string::npos);
}

TEST_F(RobotSetupTest, WaitsForACableThatIsPulledInItsMidst) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "ConfigureSonar") {
      cable.plugged = false;
      after_ms(3000, [this] { cable.plugged = true; });
    }
  };
  session->connect();
  EXPECT_GT(session->now(), time::HostTime(std::chrono::seconds(3)));
  EXPECT_EQ(protocol::config_digest(cable.robot.configuration),
            protocol::config_digest(profile.configuration));
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSetupTest, SaysWhatTheLastTryFailedAt) {
  cable.robot.configuration = profile.configuration;
  cable.robot.answer = protocol::CommandStatus::kBusy;
  const std::string reason = reason_of_failure();
  EXPECT_NE(reason.find("Arm: busy"), std::string::npos) << reason;
  EXPECT_EQ(reason.find("again and again"), std::string::npos) << reason;

  cable.robot.answers_bulk_reads = false;
  cable.robot.answer = protocol::CommandStatus::kAccepted;
  cable.robot.configuration.pan.max_cdeg = 4500;
  session = new_session(false);
  EXPECT_NE(reason_of_failure().find("reading its configuration: no answer"), std::string::npos);
}

TEST_F(RobotSetupTest, SendsNothingToABoardThatHoldsTheProfileAlready) {
  cable.robot.configuration = profile.configuration;
  session->connect();
  EXPECT_EQ(cable.robot.configurations, 0);
  EXPECT_EQ(cable.robot.bulk_reads, 0);
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSetupTest, SendsOnlyWhatTheBoardDoesNotHold) {
  cable.robot.configuration = profile.configuration;
  cable.robot.configuration.pan.max_cdeg = 4500;
  session->connect();
  EXPECT_EQ(cable.robot.configurations, 1);
  EXPECT_EQ(cable.robot.configuration.pan.max_cdeg, 9000);
}

/// A board that holds the gyro as wanted and lets go of it when it gets new pins.
class NewPins : public RobotSetupTest {
 protected:
  NewPins() {
    profile.configuration.sensors.gyro_period_ms = 10;
    session = new_session(false);
    cable.robot.configuration = profile.configuration;
    ++cable.robot.configuration.pins.pin_0;
    cable.robot.on_command = [this](std::string_view name) {
      if (name == "ConfigurePins") {
        cable.robot.configuration.sensors.gyro_period_ms = 0;
      } else if (name == "ConfigureSensors" && refuses_sensors) {
        cable.robot.answer = protocol::CommandStatus::kOutOfRange;
      }
    };
  }

  bool refuses_sensors = false;
};

TEST_F(NewPins, HaveWhatTheySwitchOffSentAgain) {
  session->connect();
  EXPECT_EQ(cable.robot.configuration.sensors.gyro_period_ms, 10);
  EXPECT_EQ(cable.robot.configurations, 2);
}

TEST_F(NewPins, HaveTheRefusalOfWhatTheySwitchOffTold) {
  refuses_sensors = true;
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
    EXPECT_NE(std::string(error.what()).find("refuses ConfigureSensors"), std::string::npos)
        << error.what();
  }
}

TEST_F(RobotSetupTest, NamesTheFieldThatTheBoardDoesNotTake) {
  cable.robot.pan_error_cdeg = 7;
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
    EXPECT_NE(std::string(error.what()).find("ConfigurePan.max_cdeg is 9007, not 9000"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(cable.robot.armed);
}

/// A session that does not come about: its error, which has this code.
class RefusedSetup : public RobotSetupTest {
 protected:
  std::string error_with(console::ExitCode code) {
    session = new_session(false);
    try {
      session->connect();
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), code);
      return error.what();
    }
    return "connected";
  }
  void let_refuse(std::string_view command) {
    cable.robot.on_command = [this, command](std::string_view name) {
      cable.robot.answer = name == command ? protocol::CommandStatus::kOutOfRange
                                           : protocol::CommandStatus::kAccepted;
    };
  }
};

TEST_F(RefusedSetup, NamesTheRobotsOfTheBoards) {
  let_refuse("ConfigureDrive");
  const std::string error = error_with(console::ExitCode::kConfigInvalid);
  EXPECT_NE(error.find("next: name the robot on this board with --robot, usually uno_2wd (uno"),
            std::string::npos)
      << error;
}

TEST_F(RefusedSetup, SaysWhichBoardsHaveATimerForServos) {
  profile.configuration.wiring.bridge =
      static_cast<std::uint8_t>(protocol::MotorBridgeKind::kServo);
  let_refuse("ConfigureWiring");
  const std::string error = error_with(console::ExitCode::kConfigInvalid);
  EXPECT_NE(error.find("Arduino Mega 2560, STM32F103 board or Raspberry Pi Pico"),
            std::string::npos)
      << error;
}

TEST_F(RefusedSetup, SaysWhichPinsADriverNeeds) {
  profile.configuration.wiring.bridge =
      static_cast<std::uint8_t>(protocol::MotorBridgeKind::kIn1In2Pwm);
  let_refuse("ConfigureWiring");
  const std::string error = error_with(console::ExitCode::kConfigInvalid);
  EXPECT_NE(error.find("free pin_0 and pin_1"), std::string::npos) << error;
}

/// A robot whose firmware is older than the wiring of motors.
class OlderRobot : public RefusedSetup {
 protected:
  OlderRobot() {
    cable.robot.holds_wiring = false;
    cable.robot.protocol_minor = 2;
    cable.robot.schema = robot_link::description_of<robot_link::other_messages::BeforeWiring>();
    cable.robot.schema_digest =
        protocol::DigestOf<robot_link::other_messages::BeforeWiring>::kValue;
  }
};

TEST_F(OlderRobot, IsSetUpWithTheUsualWiring) {
  session->connect();
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_EQ(cable.robot.configuration.drive.max_ticks_per_s, profile.ticks_per_s());
  EXPECT_GT(cable.robot.configurations, 0);

  cable.robot.configurations = 0;
  cable.robot.power_on(2);
  cable.robot.configuration = profile.configuration;
  session = new_session(false);
  session->connect();
  EXPECT_EQ(cable.robot.configurations, 0) << "its digest is that of what it holds";
}

TEST_F(OlderRobot, IsRefusedWhereTheProfileWantsOtherBridges) {
  profile.configuration.wiring.bridge =
      static_cast<std::uint8_t>(protocol::MotorBridgeKind::kTwoPwm);
  const std::string error = error_with(console::ExitCode::kFirmwareMismatch);
  EXPECT_NE(error.find("older than protocol 1.3"), std::string::npos) << error;
  EXPECT_NE(error.find("next: ./run flash"), std::string::npos) << error;
  EXPECT_FALSE(cable.robot.armed);
  EXPECT_EQ(cable.robot.configurations, 0);
}

/// A robot whose firmware is older than the scalar sensor.
class RobotBeforeScalar : public RefusedSetup {
 protected:
  RobotBeforeScalar() {
    cable.robot.holds_scalar = false;
    cable.robot.protocol_minor = 3;
    cable.robot.schema = robot_link::description_of<robot_link::other_messages::BeforeScalar>();
    cable.robot.schema_digest =
        protocol::DigestOf<robot_link::other_messages::BeforeScalar>::kValue;
  }
};

TEST_F(RobotBeforeScalar, IsSetUpWithoutOneAndWithItsWiring) {
  profile.configuration.wiring.bridge =
      static_cast<std::uint8_t>(protocol::MotorBridgeKind::kTwoPwm);
  session = new_session(false);
  session->connect();
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_EQ(cable.robot.configuration.wiring.bridge, profile.configuration.wiring.bridge);
}

TEST_F(RobotBeforeScalar, IsRefusedWhereTheProfileHasOne) {
  profile.configuration.scalar.period_ms = 100;
  const std::string error = error_with(console::ExitCode::kFirmwareMismatch);
  EXPECT_NE(error.find("older than protocol 1.4"), std::string::npos) << error;
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RefusedSetup, SaysThatABrickHasNoPinForAScalarSensor) {
  profile.configuration.pins.pin_0 = protocol::kPinScalarPulses;
  profile.configuration.scalar.period_ms = 100;
  let_refuse("ConfigurePins");
  std::string error = error_with(console::ExitCode::kConfigInvalid);
  EXPECT_NE(error.find("an EV3 has ports in place of spare pins"), std::string::npos) << error;
  cable.robot.capabilities = protocol::kCapabilityScalar;
  error = error_with(console::ExitCode::kConfigInvalid);
  EXPECT_NE(error.find("put 'scalar_pulses' on pin_0 .. pin_2"), std::string::npos) << error;
}

TEST_F(RobotSetupTest, TakesARefusedProfileForInvalid) {
  cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
  }
}

}  // namespace
}  // namespace echomap::session
