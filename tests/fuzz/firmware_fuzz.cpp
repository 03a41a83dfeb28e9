// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "firmware/boards/native/native_board.hpp"
#include "protocol/version.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

namespace protocol = echomap::protocol;
using echomap::fuzz::Input;
using echomap::fuzz::Reader;
using echomap::fuzz::require;
using echomap::native::NativeBoard;

constexpr std::int64_t kMs = 1000000;
/// The longest time to live, and the time that braking takes (docs/protocol.md).
constexpr std::int64_t kAtRestNs = (500 + 128 + 10) * kMs;

/// What the input says next; the rest of a byte's values wrap round.
enum Step : std::uint8_t {
  kBytes,
  kFrame,
  kGreet,
  kWait,
  kEdge,
  kEcho,
  kBump,
  kLevel,
  kVoltage,
  kTwoWire,
  kSteps
};

/// Hears what the robot is told: whether that may have armed it.
class ArmWatch {
 public:
  void hear(const Input& bytes) {
    for (const std::uint8_t byte : bytes) {
      if (decoder_.take(byte) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame frame = decoder_.frame();
        protocol::Dispatcher<protocol::MessagesToRobot>::dispatch(frame.id, frame.payload, *this);
      }
    }
  }
  bool may_be_armed() const { return armed_; }

  void operator()(const protocol::Hello& /*hello*/) { greeted_ = true; }
  void operator()(const protocol::Arm& arm) { armed_ = armed_ || (greeted_ && arm.armed != 0); }
  template <class M>
  void operator()(const M& /*message*/) {}

 private:
  protocol::FrameDecoder decoder_{protocol::MessagesToRobot::find_schema};
  bool greeted_ = false;
  bool armed_ = false;
};

/// The whole portable firmware, whose host, wheels, sonar, contacts, spare pins and
/// two-wire device do what the input wants.
class Robot {
 public:
  Robot() {
    board_.on_sent = [this](std::uint8_t byte) { sent_.hear(byte); };
    board_.on_trigger = nullptr;
    board_.set_bump(false, false);
    board_.set_bump(true, false);
    for (std::uint8_t pin = 0; pin < NativeBoard::kAuxPins; ++pin) {
      board_.set_aux_level(pin, true);
      board_.set_aux_analog(pin, 0);
    }
    board_.two_wire.on_read = [this](std::uint8_t, std::uint8_t) { return answer_; };
    board_.two_wire.on_write = [this](std::uint8_t, std::uint8_t, std::uint8_t) {
      return answer_.has_value();
    };
    board_.two_wire.held = false;
    board_.power_on();
  }
  ~Robot() {
    board_.on_sent = nullptr;
    board_.two_wire = {};
  }
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  void follow(Reader& input) {
    switch (input.byte() % kSteps) {
      case kBytes:
        hear(input.exactly(input.byte() % 64));
        break;
      case kFrame:
        hear(host_.next(input));
        break;
      case kGreet:
        greet(input.byte());
        break;
      case kWait:
        run(input.byte() * kMs / 16);
        break;
      case kEdge:
        edge(input.byte());
        break;
      case kEcho:
        board_.schedule_echo(board_.now_ns() + kMs, board_.now_ns() + (2 + input.byte()) * kMs / 4);
        break;
      case kLevel:
        set_level(input.byte());
        break;
      case kVoltage:
        set_voltage(input);
        break;
      case kTwoWire:
        set_two_wire(input);
        break;
      default:
        bump(input.byte());
    }
    require(watch_.may_be_armed() || at_rest(), "no wheel turns before Arm");
  }
  /// The host falls silent: the wheels have to come to rest, and the program to live on.
  void end() {
    run(heard_bytes_ * NativeBoard::kByteNs + kAtRestNs);
    require(at_rest(), "the wheels rest when the host is silent");
    const std::size_t frames = sent_.frames();
    const std::uint32_t kicks = board_.watchdog_kicks();
    hear({0});
    hear(hello());
    run(50 * kMs);
    require(sent_.frames() > frames, "a Hello is answered");
    require(board_.watchdog_kicks() > kicks, "the watchdog is kicked on");
  }

 private:
  bool at_rest() const { return board_.left_duty() == 0 && board_.right_duty() == 0; }
  void run(std::int64_t duration_ns) {
    board_.run_until_ns(board_.now_ns() + duration_ns);
    require(std::abs(board_.left_duty()) <= 255 && std::abs(board_.right_duty()) <= 255,
            "a duty is at most 255");
  }
  void hear(const Input& bytes) {
    watch_.hear(bytes);
    board_.receive(bytes.data(), bytes.size());
    heard_bytes_ += static_cast<std::int64_t>(bytes.size());
  }
  Input hello() {
    return host_.of(protocol::Hello{protocol::kProtocolMajor,
                                    protocol::kProtocolMinor,
                                    protocol::AllMessages::digest(),
                                    0x5E55});
  }
  /// Hello and Arm, and time to do them.
  void greet(std::uint8_t command_id) {
    hear(hello());
    hear(host_.of(protocol::Arm{command_id, 1}));
    run(10 * kMs);
  }
  void edge(std::uint8_t bits) {
    board_.schedule_encoder_edge(
        (bits & 1U) != 0, board_.now_ns() + bits * kMs / 64, (bits & 2U) != 0, (bits & 4U) != 0);
  }
  void bump(std::uint8_t bits) { board_.set_bump((bits & 1U) != 0, (bits & 2U) != 0); }

  void set_level(std::uint8_t bits) { board_.set_aux_level(bits % 16, (bits & 16U) != 0); }
  /// The upper eight of the converter's ten bits; the low ones are 1.
  void set_voltage(Reader& input) {
    const std::uint8_t pin = input.byte() % NativeBoard::kAuxPins;
    board_.set_aux_analog(pin, static_cast<std::uint16_t>(unsigned{input.byte()} << 2U | 3U));
  }
  /// A device that answers with this, that does not, or that holds the bus.
  void set_two_wire(Reader& input) {
    const std::uint8_t how = input.byte();
    const auto value = static_cast<std::int16_t>(input.byte() << 8U | how);
    answer_ = (how & 1U) != 0 ? std::optional(value) : std::nullopt;
    board_.two_wire.held = (how & 2U) != 0;
  }

  NativeBoard& board_ = NativeBoard::instance();
  echomap::fuzz::FrameMaker<protocol::MessagesToRobot> host_;
  echomap::fuzz::StrictEar<protocol::MessagesToHost> sent_;
  std::int64_t heard_bytes_ = 0;
  ArmWatch watch_;
  std::optional<std::int16_t> answer_;  ///< Of the two-wire device; none where there is none.
};

}  // namespace

/// Each golden frame as bytes: before Hello, and in an armed session.
std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  for (const Input& frame : golden_frames()) {
    if (frame.size() >= 64) {
      continue;
    }
    for (const Input& before : {Input{}, Input{kGreet, 1}}) {
      Input& seed = seeds.emplace_back(before);
      seed.insert(seed.end(), {kBytes, static_cast<std::uint8_t>(frame.size())});
      seed.insert(seed.end(), frame.begin(), frame.end());
      seed.insert(seed.end(), {kWait, 40, kEdge, 6, kEdge, 7, kBump, 2, kEcho, 9, kWait, 80});
      seed.insert(seed.end(),
                  {kTwoWire, 1, 0x12, kLevel, 3, kVoltage, 5, 99, kWait, 200, kTwoWire, 2, 0});
    }
  }
  return seeds;
}

/// One input is a story: what the host sends, well or badly, what the world does, and time.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Reader input({data, size});
  Robot robot;
  while (!input.at_end()) {
    robot.follow(input);
  }
  robot.end();
  return 0;
}
