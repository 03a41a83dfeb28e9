// SPDX-License-Identifier: MIT
/// What only the Pico has to show: its second boot stage, its PIO's counting, its USB cable.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/rp2040/rp2040_board.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/message_codec.hpp"
#include "protocol/version.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using rp2040::PicoLine;
using rp2040::Rp2040Board;
using rp2040::UsbTransfer;
using runner::Wheel;

constexpr const char* kImage = "echomap-pico";
/// Until Linux has enumerated a device and opened its port.
constexpr std::int64_t kPlugInMs = 400;

class PicoBoot : public ::testing::Test {
 protected:
  ~PicoBoot() override { std::filesystem::remove(copy_); }

  /// The image with this byte of its flash inverted.
  std::filesystem::path spoilt_at(std::size_t at) {
    const std::filesystem::path folder = std::filesystem::path(ECHOMAP_BINARY_DIR) / "firmware";
    std::ifstream image(folder / "echomap-pico.bin", std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(image), {}};
    bytes.at(at) = static_cast<char>(~bytes.at(at));
    std::ofstream(copy_, std::ios::binary).write(bytes.data(), std::ssize(bytes));
    return copy_;
  }

  const std::filesystem::path copy_ = std::filesystem::temp_directory_path() /
                                      ("echomap-pico-" + std::to_string(::getpid()) + ".bin");
};

TEST_F(PicoBoot, RomRefusesASecondStageWithOneWrongByte) {
  constexpr std::size_t kLastOfChecked = 251;
  EXPECT_THROW(Rp2040Board(spoilt_at(kLastOfChecked), PicoLine::kUart), std::runtime_error);
}

TEST_F(PicoBoot, TimerIsSetToMicrosecondsOfTheCrystal) {
  constexpr std::uint32_t kWatchdogTick = 0x4005'802C;
  constexpr std::uint32_t kTimerRawLow = 0x4005'4028;
  Rp2040Board board(release_image(kImage), PicoLine::kUart);
  board.run_until(10 * kMs);
  EXPECT_EQ(board.peek(kWatchdogTick) & 0x3FFU, 0x200U | 12U) << "12 MHz, and enabled";
  const std::uint32_t before = board.peek(kTimerRawLow);
  board.run_until(board.now_ns() + 10 * kMs);
  EXPECT_NEAR(double(board.peek(kTimerRawLow) - before), 10'000.0, 1.0);
}

/// What a program hangs in: with interrupts open its warning resets the chip, else the watchdog.
enum Hang : std::uint32_t {
  kInterruptsOpen = 0xE7FE'B662,    // cpsie i; b .
  kInterruptsLocked = 0xE7FE'B672,  // cpsid i; b .
};

class PicoWatchdog : public ::testing::TestWithParam<Hang> {};

INSTANTIATE_TEST_SUITE_P(Hangs,
                         PicoWatchdog,
                         ::testing::Values(kInterruptsOpen, kInterruptsLocked));

TEST_P(PicoWatchdog, ResetsAHangingProgramOnceAndLetsItGoOn) {
  constexpr std::uint32_t kTrap = 0x2003'0000;  // Behind program and stack.
  RobotSession robot{release_image(kImage)};
  ASSERT_TRUE(robot.connect());
  auto& board = dynamic_cast<Rp2040Board&>(robot.board());
  board.poke(kTrap, GetParam());
  board.jump(kTrap);
  robot.run_ms(300);
  EXPECT_EQ(board.resets(), 1U);
  robot.run_ms(4'000);
  EXPECT_EQ(board.resets(), 1U);
  const auto hello = robot.connect(4712);
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->reset_cause, protocol::kResetWatchdog);
}

class PicoEncoders : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(JitterPercent, PicoEncoders, ::testing::Values(0, 20, 40));

/// One wheel's edges at a rate, each off its time by up to so much of the period.
class JitteryWheel {
 public:
  JitteryWheel(runner::SimulatedBoard& board, Wheel wheel, double jitter, std::uint32_t seed)
      : board_(board), wheel_(wheel), jitter_(-jitter, jitter), random_(seed) {}

  void turn(std::int64_t period_ns, int edges) {
    const std::int64_t start_ns = board_.now_ns() + period_ns;
    for (int i = 0; i < std::abs(edges); ++i) {
      count_ += edges > 0 ? 1 : -1;
      const auto phase = static_cast<unsigned>(count_) & 3U;
      const double off_ns = jitter_(random_) * double(period_ns);
      board_.schedule_encoder_edge(wheel_,
                                   start_ns + i * period_ns + std::int64_t(off_ns),
                                   phase == 1 || phase == 2,
                                   phase >= 2);
    }
  }

  std::int16_t count() const { return static_cast<std::int16_t>(count_); }

 private:
  runner::SimulatedBoard& board_;
  Wheel wheel_;
  std::uniform_real_distribution<double> jitter_;
  std::mt19937 random_;
  int count_ = 0;
};

TEST_P(PicoEncoders, CountEveryOfTwoHundredThousandEdgesASecondOfBothWheels) {
  constexpr std::int64_t kPeriodNs = 5'000;
  constexpr int kEdgesOfStep = 1'000;
  constexpr int kSteps = 20;
  RobotSession robot{release_image(kImage)};
  ASSERT_TRUE(robot.connect());
  const double jitter = GetParam() * 1e-2;
  JitteryWheel left(robot.board(), Wheel::kLeft, jitter, 1);
  JitteryWheel right(robot.board(), Wheel::kRight, jitter, 2);
  for (int step = 0; step < kSteps; ++step) {
    left.turn(kPeriodNs, step % 4 == 3 ? -kEdgesOfStep : kEdgesOfStep);
    right.turn(kPeriodNs, step % 3 == 0 ? kEdgesOfStep : -kEdgesOfStep);
    robot.run_ms((kEdgesOfStep + 2) * kPeriodNs / kMs + 1);
  }
  robot.run_ms(50);
  const auto odometry = robot.last<protocol::Odometry>();
  ASSERT_TRUE(odometry);
  EXPECT_EQ(left.count(), 10'000);
  EXPECT_EQ(odometry->left_ticks, left.count());
  EXPECT_EQ(odometry->right_ticks, right.count());
  robot.run_ms(1'100);
  const auto health = robot.last<protocol::Health>();
  ASSERT_TRUE(health);
  EXPECT_EQ(health->encoder_errors, 0);
}

/// A robot whose line is the USB cable to a host like Linux.
class UsbRobot {
 public:
  UsbRobot() {
    board.on_sent = [this](std::uint8_t byte) { take(byte); };
  }

  template <class M>
  void operator()(const M&) {}
  void operator()(const protocol::HelloReply& reply) { session_ = reply.session; }
  void operator()(const protocol::Odometry&) { ++odometries; }

  void run_ms(std::int64_t ms) { board.run_until(board.now_ns() + ms * kMs); }

  bool answers_hello(std::uint16_t session) {
    const protocol::ByteSpan frame = encoder_.encode(
        protocol::Hello{
            protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session},
        seq_++);
    constexpr std::uint8_t kDelimiter = 0;
    session_.reset();
    board.receive({&kDelimiter, 1});
    board.receive({frame.data, frame.size});
    run_ms(50);
    return session_ == session;
  }

  /// A control transfer of one's own, and its outcome.
  UsbTransfer control(const rp2040::UsbRequest& request, std::vector<std::uint8_t> data = {}) {
    UsbTransfer outcome;
    board.usb_host().request(
        request, std::move(data), [&](const UsbTransfer& end) { outcome = end; });
    run_ms(20);
    return outcome;
  }

  Rp2040Board board{release_image(kImage), PicoLine::kUsb};
  /// Each byte of the robot and when it came.
  std::vector<std::pair<std::int64_t, std::uint8_t>> bytes;
  int odometries = 0;

 private:
  void take(std::uint8_t byte) {
    bytes.emplace_back(board.now_ns(), byte);
    if (decoder_.take(byte) == protocol::DecodeStatus::kFrame) {
      const protocol::Frame frame = decoder_.frame();
      protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, *this);
    }
  }

  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  std::uint8_t seq_ = 0;
  std::optional<std::uint16_t> session_;
};

class PicoOnUsb : protected UsbRobot, public ::testing::Test {};

TEST_F(PicoOnUsb, IsASerialPortWithItsNamesOnceItIsPluggedIn) {
  run_ms(kPlugInMs);
  const rp2040::UsbHost& host = board.usb_host();
  ASSERT_TRUE(host.is_open());
  EXPECT_EQ(host.enumerations(), 1U);
  const auto& device = host.device_descriptor();
  ASSERT_EQ(device.size(), 18U);
  EXPECT_EQ(device[8] | device[9] << 8, 0x2E8A) << "vendor";
  EXPECT_EQ(device[10] | device[11] << 8, 0x000A) << "product";
  const auto& configuration = host.configuration();
  ASSERT_GT(configuration.size(), 9U);
  EXPECT_EQ(configuration.size(), std::size_t(configuration[2] | configuration[3] << 8));
  EXPECT_EQ(configuration[4], 2) << "interfaces";
  ASSERT_EQ(host.strings().size(), 3U);
  EXPECT_FALSE(host.strings()[2].empty()) << "serial number";
}

TEST_F(PicoOnUsb, AnswersHelloAndTelemetersThroughTheCable) {
  run_ms(kPlugInMs);
  ASSERT_TRUE(answers_hello(4711));
  odometries = 0;
  run_ms(1'000);
  EXPECT_NEAR(odometries, 50, 1);
}

TEST_F(PicoOnUsb, StallsWhatItDoesNotKnowAndServesTheNextTransfer) {
  run_ms(kPlugInMs);
  constexpr rp2040::UsbRequest kQualifier{0x80, 6, 0x0600, 0, 10};
  constexpr rp2040::UsbRequest kVendorRead{0xC0, 1, 0, 0, 4};
  constexpr rp2040::UsbRequest kVendorWrite{0x40, 1, 0, 0, 0};
  constexpr rp2040::UsbRequest kConfigurationIs{0x80, 8, 0, 0, 1};
  for (const rp2040::UsbRequest& unknown : {kQualifier, kVendorRead, kVendorWrite}) {
    EXPECT_EQ(control(unknown).end, UsbTransfer::End::kStalled) << int(unknown.type);
    const UsbTransfer known = control(kConfigurationIs);
    EXPECT_EQ(known.end, UsbTransfer::End::kDone);
    EXPECT_EQ(known.bytes, std::vector<std::uint8_t>{1});
  }
  EXPECT_TRUE(answers_hello(4711));
}

TEST_F(PicoOnUsb, KeepsTheLineCodingThatItIsTold) {
  run_ms(kPlugInMs);
  const std::vector<std::uint8_t> coding{0x00, 0xC2, 0x01, 0x00, 0, 0, 8};  // 115200 8N1
  EXPECT_EQ(control({0x21, 0x20, 0, 0, 7}, coding).end, UsbTransfer::End::kDone);
  const UsbTransfer told = control({0xA1, 0x21, 0, 0, 7});
  EXPECT_EQ(told.end, UsbTransfer::End::kDone);
  EXPECT_EQ(told.bytes, coding);
}

TEST_F(PicoOnUsb, IsEnumeratedAgainAfterABusReset) {
  run_ms(kPlugInMs);
  ASSERT_TRUE(answers_hello(4711));
  board.usb_host().reset(board.now_ns());
  EXPECT_FALSE(board.usb_host().is_open());
  run_ms(kPlugInMs);
  EXPECT_TRUE(board.usb_host().is_open());
  EXPECT_EQ(board.usb_host().enumerations(), 2U);
  EXPECT_TRUE(answers_hello(4711));
  EXPECT_EQ(board.resets(), 0U);
}

TEST_F(PicoOnUsb, GoesOnAfterAReplugWithoutAReset) {
  run_ms(kPlugInMs);
  ASSERT_TRUE(answers_hello(4711));
  board.usb_host().plug(false, board.now_ns());
  run_ms(300);
  bytes.clear();
  run_ms(100);
  EXPECT_TRUE(bytes.empty());
  board.usb_host().plug(true, board.now_ns());
  run_ms(kPlugInMs);
  EXPECT_TRUE(board.usb_host().is_open());
  EXPECT_TRUE(answers_hello(4711));
  EXPECT_EQ(board.resets(), 0U);
}

TEST_F(PicoOnUsb, SendsTheSameBytesAtTheSameTimesInEveryRun) {
  const auto run = [] {
    UsbRobot robot;
    robot.run_ms(kPlugInMs);
    EXPECT_TRUE(robot.answers_hello(4711));
    robot.run_ms(500);
    return robot.bytes;
  };
  const auto first = run();
  EXPECT_GT(first.size(), 300U);
  EXPECT_TRUE(first == run());
}

}  // namespace
}  // namespace echomap::tests
