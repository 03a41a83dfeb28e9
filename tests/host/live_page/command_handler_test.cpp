// SPDX-License-Identifier: MIT
#include "host/live_page/command_handler.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using Cause = session::StopRobot::Cause;

class CommandHandlerTest : public testing::Test {
 protected:
  std::string drive(double forward, double seen_ms) const {
    return R"({"do": "drive", "forward": )" + std::to_string(forward) + R"(, "turn": 0, "seen": )" +
           std::to_string(seen_ms) + "}";
  }
  std::string drive(double forward) const { return drive(forward, now_ms_); }
  std::string refused(std::uint64_t client, const std::string& text) {
    const auto code = handler_.answer(client, text).refused;
    return code ? std::string(name_of(*code)) : "";
  }
  /// The cause of the stop that a command is; nothing for any other.
  static std::optional<Cause> stop_of(const std::optional<session::OperatorCommand>& command) {
    const auto* stop = command ? std::get_if<session::StopRobot>(&*command) : nullptr;
    return stop == nullptr ? std::nullopt : std::optional(stop->cause);
  }

  double now_ms_ = 10000.0;
  CommandHandler handler_{std::vector<std::string>{"stop", "drive", "go", "explore", "box"},
                          [this] { return now_ms_; }};
};

TEST_F(CommandHandlerTest, AnswersWithTheClientsNumber) {
  EXPECT_EQ(handler_.answer(1, R"({"do": "explore", "seq": 12})").text, R"({"ack":12,"ok":true})");
  EXPECT_EQ(handler_.answer(1, R"({"do": "explore"})").text, R"({"ack":null,"ok":true})");
  EXPECT_EQ(handler_.answer(1, R"({"do": "fly", "seq": 13})").text,
            R"({"ack":13,"ok":false,"why":"there is no such command","code":"unknown"})");
  EXPECT_EQ(handler_.answer(1, R"({"do": "ping", "seq": 14})").text,
            R"({"ack":14,"ok":true,"clock":10000.0})");
}

TEST_F(CommandHandlerTest, StopsWhoeverDrivesAndWhateverTheAge) {
  handler_.answer(1, drive(1.0));
  const auto answer = handler_.answer(2, R"({"do": "stop", "seen": 3})");
  EXPECT_FALSE(answer.refused);
  EXPECT_EQ(stop_of(answer.command), Cause::kPressed);
}

TEST_F(CommandHandlerTest, RefusesWhatTheRunDoesNotTake) {
  EXPECT_EQ(refused(1, R"({"do": "carry-off"})"), "not-possible");
  EXPECT_EQ(refused(1, R"({"do": "speed", "factor": 2})"), "not-possible");
  EXPECT_EQ(refused(1, R"({"do": "box", "x": 1, "y": 2})"), "");
}

TEST_F(CommandHandlerTest, RefusesAllOfARunThatIsNotLive) {
  CommandHandler ended(std::nullopt, [] { return 0.0; });
  EXPECT_EQ(ended.answer(1, R"({"do": "stop"})").refused, RefusalCode::kNotPossible);
  EXPECT_EQ(ended.answer(1, R"({"do": "explore"})").refused, RefusalCode::kNotPossible);
  EXPECT_FALSE(ended.answer(1, R"({"do": "ping"})").refused);
}

TEST_F(CommandHandlerTest, RefusesToSteerByWhatIsOldOrYetToCome) {
  EXPECT_EQ(refused(1, drive(1.0, now_ms_ - 399.0)), "");
  EXPECT_EQ(refused(1, drive(1.0, now_ms_ - 401.0)), "stale");
  EXPECT_EQ(refused(1, drive(1.0, now_ms_ + 5.0)), "stale");
}

TEST_F(CommandHandlerTest, LetsAllDoEverythingWhileNobodyDrives) {
  EXPECT_EQ(refused(1, R"({"do": "explore"})"), "");
  EXPECT_EQ(refused(2, R"({"do": "go", "x": 1, "y": 2})"), "");
}

TEST_F(CommandHandlerTest, LetsTheDriverAloneMoveTheRobot) {
  handler_.answer(1, R"({"do": "name", "name": "phone"})");
  handler_.answer(1, drive(1.0));
  EXPECT_EQ(refused(2, drive(1.0)), "not-driver");
  EXPECT_EQ(refused(2, R"({"do": "explore"})"), "not-driver");
  EXPECT_EQ(refused(2, R"({"do": "go", "x": 1, "y": 2})"), "not-driver");
  EXPECT_EQ(refused(CommandHandler::kPostingClient, R"({"do": "explore"})"), "not-driver");
  EXPECT_THAT(handler_.answer(2, drive(1.0)).text, testing::HasSubstr("client 1 (phone) drives"));
  now_ms_ += 2000.0;
  EXPECT_EQ(refused(2, R"({"do": "explore"})"), "");
}

TEST_F(CommandHandlerTest, TellsWhoDrives) {
  EXPECT_FALSE(handler_.driver());
  handler_.answer(1, drive(0.0));
  EXPECT_EQ(handler_.driver()->client, 1U);
  EXPECT_EQ(handler_.driver()->name, "");
  handler_.answer(1, R"({"do": "name", "name": "\u001b[phone"})");
  EXPECT_EQ(handler_.driver()->name, "[phone");
  now_ms_ += 2000.0;
  EXPECT_FALSE(handler_.driver());
}

TEST_F(CommandHandlerTest, StopsTheRobotOfADriverThatIsGone) {
  handler_.answer(1, drive(1.0));
  EXPECT_EQ(stop_of(handler_.close(2)), std::nullopt);
  EXPECT_EQ(stop_of(handler_.close(1)), Cause::kDriverGone);
  EXPECT_FALSE(handler_.driver());
}

TEST_F(CommandHandlerTest, DoesNotStopARobotThatNobodyHasSteeredForTwoSeconds) {
  handler_.answer(1, drive(1.0));
  now_ms_ += 2000.0;
  EXPECT_EQ(stop_of(handler_.close(1)), std::nullopt);
}

TEST_F(CommandHandlerTest, DoesNotStopAnExplorationThatTheDriverHasStarted) {
  handler_.answer(1, drive(1.0));
  handler_.answer(1, R"({"do": "explore"})");
  EXPECT_FALSE(handler_.driver());
  EXPECT_EQ(stop_of(handler_.close(1)), std::nullopt);
}

TEST_F(CommandHandlerTest, StopsTheRobotThatItsDriverReleases) {
  handler_.answer(1, drive(1.0));
  EXPECT_EQ(stop_of(handler_.answer(2, R"({"do": "release"})").command), std::nullopt);
  EXPECT_EQ(stop_of(handler_.answer(1, R"({"do": "release"})").command), Cause::kDriverGone);
  EXPECT_EQ(refused(2, drive(1.0)), "");
}

TEST_F(CommandHandlerTest, DoesNotMoveByAKeyThatIsStillHeldAfterAStop) {
  handler_.answer(1, drive(1.0));
  handler_.answer(2, R"({"do": "stop"})");
  now_ms_ += 100.0;
  EXPECT_EQ(refused(1, drive(1.0)), "busy");
  EXPECT_EQ(refused(1, drive(0.0)), "");
  EXPECT_EQ(refused(1, drive(1.0)), "");
}

TEST_F(CommandHandlerTest, ForgetsTheNamesOfThoseWhoAreGone) {
  handler_.answer(1, R"({"do": "name", "name": "phone"})");
  handler_.close(1);
  handler_.answer(1, drive(1.0));
  EXPECT_EQ(handler_.driver()->name, "");
}

}  // namespace
}  // namespace echomap::live_page
