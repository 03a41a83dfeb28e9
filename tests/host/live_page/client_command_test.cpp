// SPDX-License-Identifier: MIT
#include "host/live_page/client_command.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

template <typename Command>
const Command* robot_command(const ClientCommand& command) {
  const auto* robot = std::get_if<session::OperatorCommand>(&command.request);
  return robot == nullptr ? nullptr : std::get_if<Command>(robot);
}

/// The code of a text that is refused; "" where it is not.
std::string refusal(const std::string& text) {
  const ClientCommand command = parse_command(text);
  const auto* refused = std::get_if<Refusal>(&command.request);
  return refused == nullptr ? "" : std::string(name_of(refused->code));
}

TEST(ClientCommand, ReadsEveryCommandOfTheDocument) {
  const auto drive =
      parse_command(R"({"do": "drive", "seq": 3, "forward": -1, "turn": 0.25, "seen": 1234.5})");
  ASSERT_TRUE(std::holds_alternative<Drive>(drive.request));
  EXPECT_EQ(drive.seq, 3U);
  EXPECT_EQ(std::get<Drive>(drive.request).steer.forward, -1.0);
  EXPECT_EQ(std::get<Drive>(drive.request).steer.turn, 0.25);
  EXPECT_EQ(std::get<Drive>(drive.request).seen_ms, 1234.5);

  const auto go = parse_command(R"({"do": "go", "x": 1.0, "y": -2})");
  ASSERT_NE(robot_command<session::GoTo>(go), nullptr);
  EXPECT_EQ(robot_command<session::GoTo>(go)->at_m, Eigen::Vector2d(1.0, -2.0));

  const auto pose = parse_command(R"({"do": "pose", "x": 1, "y": 2, "heading": 0.5})");
  ASSERT_NE(robot_command<session::PlaceRobot>(pose), nullptr);
  EXPECT_EQ(robot_command<session::PlaceRobot>(pose)->T_map_robot.heading_rad(), 0.5);

  const auto speed = parse_command(R"({"do": "speed", "factor": 8})");
  EXPECT_EQ(robot_command<session::SetSpeed>(speed)->factor, 8.0);
  const auto box = parse_command(R"({"do": "box", "x": 0, "y": 9999})");
  EXPECT_EQ(robot_command<session::PutBox>(box)->at_m.y(), 9999.0);
  const auto cut = parse_command(R"({"do": "cut-cable", "seconds": 4})");
  EXPECT_EQ(robot_command<session::CutCable>(cut)->for_s, 4.0);
  EXPECT_NE(robot_command<session::CarryOff>(parse_command(R"({"do": "carry-off"})")), nullptr);
  EXPECT_NE(robot_command<session::ReportMoved>(parse_command(R"({"do": "moved"})")), nullptr);
  EXPECT_NE(robot_command<session::ResumeStrategy>(parse_command(R"({"do": "explore"})")), nullptr);
  EXPECT_TRUE(std::holds_alternative<ReleaseLock>(parse_command(R"({"do": "release"})").request));
  EXPECT_TRUE(std::holds_alternative<AskClock>(parse_command(R"({"do": "ping"})").request));
  const auto name = parse_command(R"({"do": "name", "name": "phone"})");
  EXPECT_EQ(std::get<NameClient>(name.request).name, "phone");
}

TEST(ClientCommand, UnderstandsAStopWhateverElseIsSaid) {
  for (const char* text : {R"({"do": "stop"})",
                           R"({"do": "stop", "seq": -1, "seen": "long ago"})",
                           R"({"seq": [], "do": "stop", "forward": 3})"}) {
    EXPECT_NE(robot_command<session::StopRobot>(parse_command(text)), nullptr) << text;
  }
}

TEST(ClientCommand, RefusesWhatIsNoCommand) {
  for (const char* text :
       {"", "{", "[]", "null", "3", "{}", R"({"do": 3})", "\xff", "{\"do\":\"go\xff\"}"}) {
    EXPECT_EQ(refusal(text), "malformed") << text;
  }
  EXPECT_EQ(refusal(R"({"do": "fly"})"), "unknown");
  EXPECT_EQ(refusal(R"({"do": "Stop"})"), "unknown");
  EXPECT_EQ(refusal(std::string(10000, '[')), "malformed");
}

TEST(ClientCommand, RefusesNumbersThatAreMissingOfAnotherTypeOrOutOfRange) {
  for (const char* text : {R"({"do": "go", "x": 1})",
                           R"({"do": "go", "x": 1, "y": "2"})",
                           R"({"do": "go", "x": 1, "y": null})",
                           R"({"do": "go", "x": 1, "y": 10001})",
                           R"({"do": "go", "x": 1, "y": 1e999})",
                           R"({"do": "go", "x": NaN, "y": 1})",
                           R"({"do": "drive", "forward": 1.01, "turn": 0, "seen": 1})",
                           R"({"do": "drive", "forward": 1, "turn": -1.01, "seen": 1})",
                           R"({"do": "drive", "forward": 1, "turn": 0})",
                           R"({"do": "drive", "forward": 1, "turn": 0, "seen": -1})",
                           R"({"do": "speed", "factor": 0.05})",
                           R"({"do": "speed", "factor": 101})",
                           R"({"do": "speed", "factor": -1})",
                           R"({"do": "speed", "factor": true})",
                           R"({"do": "cut-cable", "seconds": 61})",
                           R"({"do": "pose", "x": 1, "y": 2})",
                           R"({"do": "name", "name": 3})",
                           R"({"do": "explore", "seq": 1.5})",
                           R"({"do": "explore", "seq": -1})",
                           R"({"do": "explore", "seq": 9007199254740993})"}) {
    EXPECT_EQ(refusal(text), "malformed") << text;
  }
  EXPECT_EQ(refusal(R"({"do": "speed", "factor": 0})"), "");
  EXPECT_EQ(refusal(R"({"do": "speed", "factor": 0.1})"), "");
}

TEST(ClientCommand, SaysWhatIsWrong) {
  const ClientCommand command = parse_command(R"({"do": "go", "seq": 5, "x": 1})");
  EXPECT_EQ(command.seq, 5U);
  EXPECT_EQ(std::get<Refusal>(command.request).why, "y has to be a number");
}

TEST(ClientCommand, CountsANamesCharactersNotItsBytes) {
  const auto name_command = [](const std::string& name) {
    return R"({"do": "name", "name": ")" + name + "\"}";
  };
  std::string forty;
  for (int i = 0; i < 40; ++i) {
    forty += "ü";
  }
  EXPECT_EQ(refusal(name_command(forty)), "");
  EXPECT_EQ(refusal(name_command(forty + "x")), "malformed");
}

TEST(ClientCommand, CleansNames) {
  EXPECT_EQ(cleaned_name("a\x1b[31mb\n\x7f", 40), "a[31mb");
  EXPECT_EQ(cleaned_name("a\xc2\x9b"
                         "b",
                         40),
            "ab")
      << "a control character of two bytes";
  EXPECT_EQ(cleaned_name("\xff"
                         "a\xe2\x82",
                         40),
            "a")
      << "broken UTF-8";
  EXPECT_EQ(cleaned_name("\xc0\x80"
                         "a\xed\xa0\x80",
                         40),
            "a")
      << "overlong, half a pair";
  EXPECT_EQ(cleaned_name("€\xf0\x9f\xa4\x96z", 2), "€\xf0\x9f\xa4\x96");
  EXPECT_EQ(cleaned_name("", 40), "");
}

}  // namespace
}  // namespace echomap::live_page
