// SPDX-License-Identifier: MIT
#include "host/session/port_choice.hpp"

#include <algorithm>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/transport/transport_error.hpp"
#include "tests/host/robot_link/fake_robot.hpp"

namespace echomap::session {
namespace {

using robot_link::FakeRobot;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A port with a robot behind it, or with something that only ever says `line`.
struct Device {
  bool is_robot = false;
  std::string line;
  FakeRobot robot;
  transport::StreamStatus status = transport::StreamStatus::kOpen;
  int reads = 0;
  int baud = 250'000;          ///< Of its image,
  int baud_of_line = 250'000;  ///< and of the port.
};

class DeviceStream final : public transport::ByteStream {
 public:
  DeviceStream(std::string name, Device& device) : name_(std::move(name)), device_(device) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    ++device_.reads;
    if (device_.baud != device_.baud_of_line) {
      return 0;
    }
    auto bytes = device_.is_robot ? device_.robot.take_outgoing()
                                  : FakeRobot::Bytes(device_.line.begin(), device_.line.end());
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  void write(std::span<const std::uint8_t> bytes) override {
    if (device_.baud == device_.baud_of_line) {
      device_.robot.receive(bytes);
    }
  }
  bool set_baud(int baud) override {
    device_.baud_of_line = baud;
    return true;
  }
  transport::StreamStatus status() const override { return device_.status; }
  std::string close_reason() const override { return ""; }
  std::string name() const override { return name_; }

 private:
  std::string name_;
  Device& device_;
};

class PortChoice : public testing::Test {
 protected:
  std::unique_ptr<transport::ByteStream> choose(const std::vector<std::string>& ports) {
    const OpenPort open =
        [this](const std::string& port) -> std::unique_ptr<transport::ByteStream> {
      const auto device = devices.find(port);
      if (device == devices.end()) {
        throw transport::TransportError(
            "cannot open " + port, "it is not there", "plug it in first");
      }
      return std::make_unique<DeviceStream>(port, device->second);
    };
    return choose_port(ports, open, 7, true);
  }
  std::string refusal(const std::vector<std::string>& ports) {
    try {
      choose(ports);
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), console::ExitCode::kNoRobot);
      return error.what();
    }
    return "no error";
  }

  std::map<std::string, Device> devices{{"modem", {false, "ERROR\r\n", {}}},
                                        {"silent", {false, "", {}}},
                                        {"robot", {true, "", {}}},
                                        {"twin", {true, "", {}}}};
};

TEST_F(PortChoice, TakesTheOneThatAnswersAndSaysHelloOnceToEach) {
  EXPECT_EQ(choose({"modem", "silent", "gone", "robot"})->name(), "robot");
  for (const auto& [name, device] : devices) {
    EXPECT_EQ(device.robot.hellos, name == "twin" ? 0 : 1) << name;
  }
}

TEST_F(PortChoice, TakesASinglePortAsItIs) {
  EXPECT_EQ(choose({"silent"})->name(), "silent");
  EXPECT_EQ(devices.at("silent").robot.hellos, 0);
}

TEST_F(PortChoice, FindsARobotOfAnOlderImageAmongSeveral) {
  devices.at("robot").baud = 115'200;
  EXPECT_EQ(choose({"silent", "robot"})->name(), "robot");
  EXPECT_EQ(devices.at("robot").robot.hellos, 1);
}

TEST_F(PortChoice, NeverGuessesBetweenTwoRobots) {
  EXPECT_THAT(refusal({"robot", "twin", "silent"}),
              AllOf(HasSubstr("more than one robot"), HasSubstr("twin: a robot, boot")));
}

TEST_F(PortChoice, LeavesTheRobotOfAnotherProgramAloneWhereOneIsFree) {
  devices.at("twin").robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
  EXPECT_EQ(choose({"robot", "twin"})->name(), "robot");
  EXPECT_EQ(devices.at("twin").robot.session(), 99);
  devices.at("robot").robot.hear_of_another(protocol::TakeOver{98});
  EXPECT_THAT(refusal({"robot", "twin"}),
              AllOf(HasSubstr("more than one robot"), HasSubstr("busy: another program holds it")));
}

TEST_F(PortChoice, TellsWhatEachPortSaidWhereNoneIsARobot) {
  EXPECT_THAT(refusal({"modem", "silent", "gone"}),
              AllOf(HasSubstr("ERROR"),
                    HasSubstr("silent: silent"),
                    HasSubstr("gone: it is not there\n    next: plug it in first\n")));
}

TEST_F(PortChoice, ListensToNoPortThatIsClosed) {
  devices.at("silent").status = transport::StreamStatus::kClosed;
  EXPECT_THAT(refusal({"silent", "gone"}), HasSubstr("no robot answers"));
  EXPECT_EQ(devices.at("silent").reads, 0);
}

/// A desk that nobody names a port of, and somebody who answers questions.
class PossibleRobots : public testing::Test {
 protected:
  /// The chosen port, or why there is none.
  std::string choose(const std::vector<transport::PortInfo>& ports) {
    const auto is_in = [](const std::vector<std::string>& names) {
      return [names](const transport::PortInfo& port) {
        return std::ranges::find(names, port.name) != names.end();
      };
    };
    const auto ask = [this](const std::string& question) -> std::optional<std::string> {
      questions.push_back(question);
      if (answers.empty()) {
        return std::nullopt;
      }
      const std::string answer = answers.front();
      answers.erase(answers.begin());
      return answer;
    };
    try {
      return choose_possible_robot({ports, is_in(known), is_in(held), ask, why_none});
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), console::ExitCode::kNoRobot);
      return error.what();
    }
  }

  std::vector<std::string> known;
  std::vector<std::string> held;
  std::vector<std::string> answers;
  std::vector<std::string> questions;
  std::string why_none;
  const transport::PortInfo uno{"/dev/ttyACM0", "Uno", "754", transport::UsbId{0x2341, 0x0043}};
  const transport::PortInfo nano{"/dev/ttyUSB0", "USB", "", transport::UsbId{0x1a86, 0x7523}};
  const transport::PortInfo modem{"/dev/ttyUSB1", "HUAWEI", "", transport::UsbId{0x12d1, 0x1506}};
  const transport::PortInfo radio{"/dev/rfcomm0", "Bluetooth", ""};
};

TEST_F(PossibleRobots, AreNotThereWhereNoIdIsOfABoard) {
  EXPECT_THAT(choose({}), HasSubstr("next: plug the robot in"));
  EXPECT_THAT(choose({modem, radio}), AllOf(HasSubstr("HUAWEI"), HasSubstr("--port")));
  why_none = "brltty has taken it\n  next: mask it";
  EXPECT_THAT(choose({}), HasSubstr("brltty has taken it\n  next: mask it"));
  EXPECT_TRUE(questions.empty());
}

TEST_F(PossibleRobots, AreTakenUnaskedWhereOneHasAnsweredBefore) {
  known = {nano.name};
  EXPECT_EQ(choose({modem, nano}), nano.name);
  EXPECT_EQ(choose({uno, nano}), nano.name);
  known = {radio.name};
  EXPECT_EQ(choose({radio}), radio.name) << "the user named it once";
  EXPECT_TRUE(questions.empty());
}

TEST_F(PossibleRobots, AreAskedForOnceWhereNoneHasAnswered) {
  answers = {"yes"};
  EXPECT_EQ(choose({modem, nano}), nano.name);
  EXPECT_THAT(questions.at(0), HasSubstr("CH340 (1a86:7523)"));
  answers = {"no"};
  EXPECT_THAT(choose({nano}), HasSubstr("no port was chosen\n  next: "));
}

TEST_F(PossibleRobots, AreNamedWhereNobodyCanBeAsked) {
  EXPECT_THAT(choose({nano}), AllOf(HasSubstr("CH340"), HasSubstr("--port /dev/ttyUSB0")));
  EXPECT_THAT(choose({uno, nano}),
              AllOf(HasSubstr("1  /dev/ttyACM0: Arduino Uno R3 (2341:0043)"),
                    HasSubstr("2  /dev/ttyUSB0"),
                    HasSubstr("next: name one, as in --port /dev/ttyACM0")));
}

TEST_F(PossibleRobots, AreChosenByNumberFromAList) {
  answers = {"3", "uno", "2"};
  EXPECT_EQ(choose({uno, nano}), nano.name);
  EXPECT_EQ(questions.size(), 3U);
  answers = {""};
  EXPECT_THAT(choose({uno, nano}), HasSubstr("next: name one"));
}

TEST_F(PossibleRobots, AreTheFreeOneWhereAnotherRuns) {
  known = {uno.name, nano.name};
  held = {uno.name};
  EXPECT_EQ(choose({uno, nano}), nano.name);
  held = {};
  EXPECT_THAT(choose({uno, nano}), HasSubstr("a robot answered here before"));
  known = {uno.name};
  held = {uno.name};
  EXPECT_THAT(choose({uno, nano}), HasSubstr("in use by another program"));
}

TEST(CandidatePorts, AreWhatIsNamedAndAnIdHasToFit) {
  const PortSurroundings here{{{"/dev/ttyACM1", "Uno", "754"}}, {}, {}, {}};
  EXPECT_EQ(candidate_ports({"/dev/ttyACM0", "tcp://a:1", "id:754"}, here),
            (std::vector<std::string>{"/dev/ttyACM0", "tcp://a:1", "/dev/ttyACM1"}));
  EXPECT_THROW(candidate_ports({"id:no such device"}, here), console::CommandError);
}

}  // namespace
}  // namespace echomap::session
