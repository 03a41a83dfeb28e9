// SPDX-License-Identifier: MIT
#include "host/session/port_choice.hpp"

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
};

class DeviceStream final : public transport::ByteStream {
 public:
  DeviceStream(std::string name, Device& device) : name_(std::move(name)), device_(device) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    ++device_.reads;
    auto bytes = device_.is_robot ? device_.robot.take_outgoing()
                                  : FakeRobot::Bytes(device_.line.begin(), device_.line.end());
    std::copy(bytes.begin(), bytes.end(), into.begin());
    return bytes.size();
  }
  void write(std::span<const std::uint8_t> bytes) override { device_.robot.receive(bytes); }
  transport::StreamStatus status() const override { return device_.status; }
  std::string close_reason() const override { return ""; }
  std::string name() const override { return name_; }

 private:
  std::string name_;
  Device& device_;
};

class PortChoice : public testing::Test {
 protected:
  std::unique_ptr<transport::ByteStream> choose(const std::vector<std::string>& ports,
                                                bool are_named = true) {
    const OpenPort open =
        [this](const std::string& port) -> std::unique_ptr<transport::ByteStream> {
      const auto device = devices.find(port);
      if (device == devices.end()) {
        throw transport::TransportError(
            "cannot open " + port, "it is not there", "plug it in first");
      }
      return std::make_unique<DeviceStream>(port, device->second);
    };
    return choose_port({ports, are_named}, open, 7);
  }
  std::string refusal(const std::vector<std::string>& ports, bool are_named = true) {
    try {
      choose(ports, are_named);
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

TEST_F(PortChoice, AsksASinglePortThatNobodyNamed) {
  EXPECT_EQ(choose({"robot"}, false)->name(), "robot");
  EXPECT_EQ(devices.at("robot").robot.hellos, 1);
  EXPECT_THAT(refusal({"modem"}, false), AllOf(HasSubstr("no robot answers"), HasSubstr("ERROR")));
  EXPECT_EQ(devices.at("modem").robot.hellos, 1);
}

TEST_F(PortChoice, TakesASingleNamedPortAsItIs) {
  EXPECT_EQ(choose({"silent"})->name(), "silent");
  EXPECT_EQ(devices.at("silent").robot.hellos, 0);
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

TEST_F(PortChoice, WithoutAPortThereIsNoRobot) {
  EXPECT_THAT(refusal({}), HasSubstr("no USB or Bluetooth serial port"));
}

TEST(CandidatePorts, AreWhatIsNamedAndAnIdHasToFit) {
  const CandidatePorts candidates = candidate_ports({"/dev/ttyACM0", "tcp://a:1"});
  EXPECT_EQ(candidates.ports, (std::vector<std::string>{"/dev/ttyACM0", "tcp://a:1"}));
  EXPECT_TRUE(candidates.are_named);
  EXPECT_FALSE(candidate_ports({}).are_named);
  EXPECT_THROW(candidate_ports({"id:no such device"}), console::CommandError);
}

}  // namespace
}  // namespace echomap::session
