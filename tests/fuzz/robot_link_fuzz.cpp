// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdint>
#include <set>
#include <variant>

#include "host/robot_link/robot_link.hpp"
#include "protocol/version.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

namespace protocol = echomap::protocol;
namespace robot_link = echomap::robot_link;
using echomap::fuzz::Input;
using echomap::fuzz::Reader;
using echomap::fuzz::require;

constexpr std::uint16_t kSession = 0x5E55;
constexpr std::size_t kMaxCommands = 64;

/// What the input says next; the rest of a byte's values wrap round.
enum Step : std::uint8_t { kBytes, kFrame, kReply, kAck, kWait, kCommand, kSetpoint, kSteps };

/// A host whose robot says and whose user does what the input wants.
class Host : public robot_link::RobotLinkListener {
 public:
  void follow(Reader& input) {
    switch (input.byte() % kSteps) {
      case kBytes:
        return hear(input.exactly(input.byte() % 64));
      case kFrame:
        return hear(robot_.next(input));
      case kReply:
        return hear(robot_.of(reply(input)));
      case kAck:
        return hear(robot_.of(protocol::Ack{input.byte(), input.byte()}));
      case kWait:
        return wait(std::chrono::milliseconds(1 + 4 * input.byte()));
      case kCommand:
        return submit(input);
      default:
        link_.keep_alive(input.byte() % 2 == 1);
        link_.send(protocol::DriveSetpoint{100, -100, 200}, now_);
    }
  }
  /// The robot falls silent: every command has to end.
  void end() {
    for (int i = 0; i < 1000 && ended_.size() < submitted_; ++i) {
      wait(std::chrono::milliseconds(20));
    }
    require(ended_.size() == submitted_, "every command ends");
  }

  void on_command_done(const robot_link::CommandResult& result) override {
    require(ended_.insert(result.ticket).second, "a command ends once");
  }

 private:
  static protocol::HelloReply reply(Reader& input) {
    protocol::HelloReply reply{};
    reply.protocol_major = protocol::kProtocolMajor;
    reply.protocol_minor = protocol::kProtocolMinor;
    reply.schema_digest = protocol::AllMessages::digest();
    reply.session = input.byte() % 8 == 0 ? 0 : kSession;
    reply.boot_id = input.byte() % 4;
    reply.reset_cause = input.byte();
    reply.tick_hz = 1000;
    reply.receive_credit_bytes = input.byte();
    return reply;
  }
  void hear(const Input& bytes) {
    link_.receive(bytes, now_);
    work();
  }
  void wait(std::chrono::milliseconds duration) {
    now_ = now_ + duration;
    work();
  }
  void work() {
    link_.poll(now_);
    for (const std::uint8_t byte : link_.take_outgoing()) {
      sent_.hear(byte);
    }
  }
  void submit(Reader& input) {
    if (submitted_ < kMaxCommands) {
      ++submitted_;
      link_.submit(input.byte() % 2 == 0 ? robot_link::Command(protocol::Arm{0, 1})
                                         : robot_link::Command(protocol::Stop{0}));
    }
  }

  robot_link::RobotLink link_{*this, kSession};
  echomap::time::HostTime now_{std::chrono::seconds(1)};
  echomap::fuzz::FrameMaker<protocol::MessagesToHost> robot_;
  echomap::fuzz::StrictEar<protocol::MessagesToRobot> sent_;
  std::size_t submitted_ = 0;
  std::set<robot_link::CommandTicket> ended_;
};

}  // namespace

/// Each golden frame as bytes, alone and in a session with a command under way.
std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds{{kReply, 1, 1, 0, 128, kCommand, 0, kAck, 1, 0, kSetpoint, 1, kWait, 50},
                           {kCommand, 0, kWait, 255, kReply, 1, 2, 0, 128, kReply, 0, 3, 1, 128}};
  const Input session{kReply, 1, 1, 0, 128, kCommand, 0};
  for (const Input& frame : golden_frames()) {
    if (frame.size() < 64) {
      Input seed = session;
      seed.insert(seed.end(), {kBytes, static_cast<std::uint8_t>(frame.size())});
      seed.insert(seed.end(), frame.begin(), frame.end());
      seeds.push_back(seed);
    }
  }
  return seeds;
}

/// One input is a story: what the robot sends, well or badly, what the user wants, and time.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Reader input({data, size});
  Host host;
  while (!input.at_end()) {
    host.follow(input);
  }
  host.end();
  return 0;
}
