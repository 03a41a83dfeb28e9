// SPDX-License-Identifier: MIT
#include "host/apps/robot_session.hpp"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "host/apps/exit_code.hpp"
#include "protocol/config_digest.hpp"
#include "tests/host/robot_link/fake_robot.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;
using robot_link::FakeRobot;

/// What a cable between session and fake robot does.
struct Cable {
  FakeRobot robot;
  bool plugged = true;
  bool powered = true;
  transport::StreamStatus status = transport::StreamStatus::kOpen;
};

class CableStream final : public transport::ByteStream {
 public:
  explicit CableStream(Cable& cable) : cable_(cable) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    const auto bytes = cable_.robot.take_outgoing();
    if (!cable_.plugged || !cable_.powered) {
      return 0;
    }
    EXPECT_LE(bytes.size(), into.size());
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  void write(std::span<const std::uint8_t> bytes) override {
    if (cable_.plugged && cable_.powered) {
      cable_.robot.receive(bytes);
    }
  }
  transport::StreamStatus status() const override { return cable_.status; }
  std::string close_reason() const override {
    return cable_.status == transport::StreamStatus::kOpen ? "" : "pulled out";
  }
  std::string name() const override { return "cable"; }

 private:
  Cable& cable_;
};

/// Five milliseconds of the robot's time a step.
class CablePace final : public Pace {
 public:
  explicit CablePace(Cable& cable) : cable_(cable) {}

  time::HostTime step(transport::ByteStream& stream,
                      std::uint64_t /*bytes_sent*/,
                      const Receive& receive) override {
    for (int i = 0; i < 5 && cable_.powered; ++i) {
      cable_.robot.advance_1ms();
    }
    now_ += std::chrono::milliseconds(5);
    std::array<std::uint8_t, 4096> buffer{};
    receive(std::span(buffer).first(stream.read_some(buffer, std::chrono::microseconds(0))));
    return now_;
  }

 private:
  Cable& cable_;
  time::HostTime now_;
};

class RobotSessionTest : public testing::Test {
 protected:
  RobotSessionTest() { cable.robot.power_on(1); }

  /// Runs `action` after that many more milliseconds of the session.
  void after_ms(int ms, std::function<void()> action) {
    session->on_step = [this,
                        at = session->now() + std::chrono::milliseconds(ms),
                        action = std::move(action)]() mutable {
      if (action && session->now() >= at) {
        std::exchange(action, nullptr)();
      }
    };
  }
  void pull_power_and_start_anew() {
    cable.robot.power_on(++boot_id);
    ++restarts;
  }

  Cable cable;
  std::uint16_t boot_id = 1;
  int restarts = 0;
  const RobotProfile profile = load_robot_profile("uno_2wd");
  pipeline::RobotPipeline pipeline{profile.geometry};
  std::unique_ptr<RobotSession> new_session(bool no_reset) {
    RobotConnection connection{
        std::make_unique<CableStream>(cable), std::make_unique<CablePace>(cable), 7};
    connection.no_reset = no_reset;
    return std::make_unique<RobotSession>(std::move(connection), profile, pipeline);
  }
  std::unique_ptr<RobotSession> session = new_session(false);
};

TEST_F(RobotSessionTest, SetsUpAndArmsAndDisarmsInTheEnd) {
  session->connect();
  EXPECT_EQ(protocol::config_digest(cable.robot.configuration),
            protocol::config_digest(profile.configuration));
  EXPECT_TRUE(cable.robot.armed);
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.moves_done.size(), 1U);
  session.reset();
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, BeginsSettingUpAnewWhenTheBoardIsResetInItsMidst) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "ConfigureSonar" && restarts == 0) {
      pull_power_and_start_anew();
    }
  };
  session->connect();
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(protocol::config_digest(cable.robot.configuration),
            protocol::config_digest(profile.configuration))
      << "the board kept some of its defaults";
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSessionTest, GivesUpOnABoardThatIsResetAgainAndAgain) {
  cable.robot.on_command = [this](std::string_view name) {
    if (name == "Arm") {
      pull_power_and_start_anew();
    }
  };
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kLinkLost);
    EXPECT_NE(std::string(error.what()).find("again and again"), std::string::npos);
  }
}

TEST_F(RobotSessionTest, SendsNothingToABoardThatHoldsTheProfileAlready) {
  cable.robot.configuration = profile.configuration;
  session->connect();
  EXPECT_EQ(cable.robot.configurations, 0);
  EXPECT_EQ(cable.robot.bulk_reads, 0);
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSessionTest, SendsOnlyWhatTheBoardDoesNotHold) {
  cable.robot.configuration = profile.configuration;
  cable.robot.configuration.pan.max_cdeg = 4500;
  session->connect();
  EXPECT_EQ(cable.robot.configurations, 1);
  EXPECT_EQ(cable.robot.configuration.pan.max_cdeg, 9000);
}

TEST_F(RobotSessionTest, NamesTheFieldThatTheBoardDoesNotTake) {
  cable.robot.pan_error_cdeg = 7;
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kConfigInvalid);
    EXPECT_NE(std::string(error.what()).find("ConfigurePan.max_cdeg is 9007, not 9000"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, EndsForSafetyWhenTheRobotIsLifted) {
  session->connect();
  cable.robot.motion_ms = 3000;
  after_ms(300, [this] { cable.robot.hazards = protocol::kHazardWheelDrop; });
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
  EXPECT_NE(session->end_reason().find("lifted"), std::string::npos);
  EXPECT_EQ(pipeline.snapshot().times_lifted, 1U);
  EXPECT_EQ(exit_code_of(*session->end()), ExitCode::kSafetyStop);
}

TEST_F(RobotSessionTest, TellsWhatTheBoardStoppedFor) {
  session->connect();
  cable.robot.outcome = protocol::MotionOutcome::kHazard;
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kHazard);
  EXPECT_FALSE(session->end()) << "a cliff is an obstacle like another";
  cable.robot.outcome = protocol::MotionOutcome::kRunaway;
  session->execute(exploration::Drive{0.2});
  EXPECT_EQ(session->end(), SessionEnd::kSafetyStop);
}

TEST_F(RobotSessionTest, TakesARefusedProfileForInvalid) {
  cable.robot.answer = protocol::CommandStatus::kOutOfRange;
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kConfigInvalid);
  }
}

TEST_F(RobotSessionTest, NamesTheFirmwareThatSpeaksAnotherProtocol) {
  cable.robot.schema_digest ^= 1U;
  cable.robot.schema = {};
  cable.robot.power_on(1);
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kFirmwareMismatch);
  }
}

TEST_F(RobotSessionTest, JoinsARobotThatRunsWhereItMustNotBeReset) {
  cable.robot.power_on(5, protocol::kResetExternal);
  for (int ms = 0; ms < 90'000; ++ms) {
    cable.robot.advance_1ms();
  }
  session = new_session(true);
  session->connect();
  EXPECT_GT(cable.robot.stamp_us(), 90'000'000U);
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
}

TEST_F(RobotSessionTest, RefusesARobotThatOpeningHasReset) {
  session = new_session(true);
  cable.powered = false;
  after_ms(200, [this] {
    cable.robot.power_on(2, protocol::kResetExternal);
    cable.powered = true;
  });
  try {
    session->connect();
    FAIL() << "connected";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kNoRobot);
    EXPECT_NE(std::string(error.what()).find("has reset the robot"), std::string::npos);
  }
  EXPECT_FALSE(cable.robot.armed);
}

TEST_F(RobotSessionTest, DoesASweepAgainThatAResetBrokeOff) {
  session->connect();
  cable.robot.motion_ms = 1000;
  after_ms(300, [this] { pull_power_and_start_anew(); });
  EXPECT_EQ(session->execute(exploration::Sweep{-1.0, 1.0, 0.1, 0.0}), MotionResult::kReached);
  EXPECT_EQ(cable.robot.sweeps, 2);
  EXPECT_TRUE(cable.robot.armed);
}

TEST_F(RobotSessionTest, DoesNotDoAMoveAgainThatAResetBrokeOff) {
  session->connect();
  cable.robot.motion_ms = 1000;
  after_ms(300, [this] { pull_power_and_start_anew(); });
  EXPECT_EQ(session->execute(exploration::Drive{0.3}), MotionResult::kInterrupted);
  EXPECT_EQ(cable.robot.moves_done.size(), 1U);
  EXPECT_FALSE(session->end());
}

TEST_F(RobotSessionTest, WaitsForALinkThatIsAway) {
  session->connect();
  cable.robot.motion_ms = 500;
  after_ms(100, [this] {
    cable.plugged = false;
    after_ms(2500, [this] { cable.plugged = true; });
  });
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->execute(exploration::Drive{0.2}), MotionResult::kReached);
  EXPECT_FALSE(session->end());
}

TEST_F(RobotSessionTest, EndsWhenTheRobotStaysAway) {
  session->connect();
  cable.plugged = false;
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
}

TEST_F(RobotSessionTest, EndsWhenTheRobotIsResetAndNeverComesBack) {
  session->connect();
  after_ms(50, [this] {
    pull_power_and_start_anew();
    after_ms(5, [this] { cable.powered = false; });
  });
  session->execute(exploration::Drive{0.1});
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
}

TEST_F(RobotSessionTest, EndsAtOnceWhenThePortIsClosed) {
  session->connect();
  after_ms(50, [this] { cable.status = transport::StreamStatus::kClosed; });
  session->execute(exploration::Drive{0.1});
  EXPECT_EQ(session->end(), SessionEnd::kLinkLost);
  EXPECT_EQ(session->end_reason(), "lost cable: pulled out");
}

}  // namespace
}  // namespace echomap::apps
