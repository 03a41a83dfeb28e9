// SPDX-License-Identifier: MIT
/// The Pico on its USB cable, with a host like Linux at the other end.
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/rp2040/rp2040_board.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/message_codec.hpp"
#include "protocol/version.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/turning_wheel.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using rp2040::PicoLine;
using rp2040::Rp2040Board;
using rp2040::UsbResume;
using rp2040::UsbTransfer;
using runner::Wheel;

/// Until Linux has enumerated a device and opened its port.
constexpr std::int64_t kPlugInMs = 400;

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

  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
    board.receive({frame.data, frame.size});
  }

  bool answers_hello(std::uint16_t session) {
    constexpr std::uint8_t kDelimiter = 0;
    session_.reset();
    board.receive({&kDelimiter, 1});
    send(protocol::Hello{
        protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session});
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

  Rp2040Board board{release_image("echomap-pico"), PicoLine::kUsb};
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
  board.plug_line(false);
  EXPECT_FALSE(board.usb_host().is_open());
  run_ms(300);
  bytes.clear();
  run_ms(100);
  EXPECT_TRUE(bytes.empty());
  board.plug_line(true);
  run_ms(kPlugInMs);
  EXPECT_TRUE(board.usb_host().is_open());
  EXPECT_EQ(board.usb_host().enumerations(), 2U);
  EXPECT_TRUE(answers_hello(4711));
  EXPECT_EQ(board.resets(), 0U);
}

class PicoOfASleepingHost : protected UsbRobot, public ::testing::TestWithParam<UsbResume> {};

INSTANTIATE_TEST_SUITE_P(Resumes,
                         PicoOfASleepingHost,
                         ::testing::Values(UsbResume::kNoticed, UsbResume::kMissed),
                         [](const auto& test) {
                           return test.param == UsbResume::kNoticed ? "Noticed" : "Missed";
                         });

TEST_P(PicoOfASleepingHost, IsSilentMeanwhileAndThenAnswersAsBefore) {
  run_ms(kPlugInMs);
  ASSERT_TRUE(answers_hello(4711));
  board.usb_host().suspend();
  run_ms(300);
  const std::size_t told = bytes.size();
  board.usb_host().resume(GetParam());
  EXPECT_EQ(bytes.size(), told);
  EXPECT_TRUE(answers_hello(4711));
  odometries = 0;
  run_ms(1'000);
  EXPECT_NEAR(odometries, 50, 1);
  EXPECT_EQ(board.usb_host().enumerations(), 1U);
  EXPECT_EQ(board.resets(), 0U);
}

TEST_P(PicoOfASleepingHost, TelemetersAfterwardsToOneThatOnlyAsksForItsConfiguration) {
  run_ms(kPlugInMs);
  ASSERT_TRUE(answers_hello(4711));
  board.usb_host().suspend();
  run_ms(300);
  board.usb_host().resume(GetParam());
  EXPECT_EQ(control({0x80, 8, 0, 0, 1}).bytes, std::vector<std::uint8_t>{1});
  odometries = 0;
  run_ms(1'000);
  EXPECT_NEAR(odometries, 50, 1);
}

/// A robot on the cable whose motors turn its wheels, and a host that keeps it going.
class DrivenPicoOnUsb : public PicoOnUsb {
 protected:
  static constexpr std::int64_t kTimeToLiveMs = 200;

  void run_driven_ms(std::int64_t ms) {
    for (std::int64_t i = 0; i < ms; ++i) {
      left.step_ms();
      right.step_ms();
      if (i % 50 == 0) {
        send(protocol::KeepAlive{kTimeToLiveMs});
      }
      run_ms(1);
      last_driven_ms = is_off() ? last_driven_ms : board.now_ns() / kMs;
    }
  }

  void drive(std::uint8_t command_id) {
    ASSERT_TRUE(answers_hello(4711));
    send(protocol::Arm{command_id, 1});
    send(protocol::DriveSetpoint{1500, 1500, kTimeToLiveMs});
    run_driven_ms(700);
    EXPECT_NEAR(left.ticks_per_s(), 1500.0, 60.0);
    EXPECT_NEAR(right.ticks_per_s(), 1500.0, 60.0);
  }

  /// Driven, it stands once the host is `gone`, and when it is `back`, until it is driven again.
  void expect_it_stands(const std::function<void()>& gone, const std::function<void()>& back) {
    run_ms(kPlugInMs);
    drive(1);
    const std::int64_t gone_ms = board.now_ns() / kMs;
    gone();
    run_driven_ms(1'000);
    EXPECT_GT(last_driven_ms, gone_ms) << "it brakes, with the motors";
    EXPECT_LE(last_driven_ms - gone_ms, kTimeToLiveMs + 100);
    const std::int64_t stood_ms = last_driven_ms;
    back();
    run_driven_ms(kPlugInMs + 500);
    EXPECT_TRUE(board.usb_host().is_open());
    EXPECT_EQ(last_driven_ms, stood_ms) << "keeping it alive does not start it";
    EXPECT_EQ(board.resets(), 0U);
    drive(2);
  }

  bool is_off() const {
    const runner::MotorDuty duty = board.motor_duty(driver);
    return duty.left == 0.0 && duty.right == 0.0;
  }

  const world::MotorDriver driver;
  DrivenWheel left{board, Wheel::kLeft, driver};
  DrivenWheel right{board, Wheel::kRight, driver};
  std::int64_t last_driven_ms = 0;
};

TEST_F(DrivenPicoOnUsb, StandsOnceItsCableIsOutAndUntilItIsDrivenAgain) {
  expect_it_stands([this] { board.usb_host().plug(false, board.now_ns()); },
                   [this] { board.usb_host().plug(true, board.now_ns()); });
}

TEST_F(DrivenPicoOnUsb, StandsOnceItsHostSleepsAndUntilItIsDrivenAgain) {
  expect_it_stands([this] { board.usb_host().suspend(); },
                   [this] { board.usb_host().resume(UsbResume::kNoticed); });
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
