// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/control_pipe.hpp"

#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::rp2040 {
namespace {

constexpr UsbRequest kRead{0x80, 6, 0x0100, 0, 18};
constexpr UsbRequest kWrite{0x21, 0x20, 0, 0, 10};
constexpr UsbRequest kSetAddress{0x00, 5, 7, 0, 0};

/// A device that answers as the test has it.
class ScriptedDevice final : public UsbCable {
 public:
  void plug(bool) override {}
  bool is_attached() const override { return true; }
  bool has_bulk_in() const override { return false; }
  void reset_bus() override {}
  void suspend_bus() override {}
  void resume_bus(UsbResume) override {}
  UsbAnswer setup(std::uint8_t address, std::span<const std::uint8_t> packet) override {
    last_address = address;
    setup_packet.assign(packet.begin(), packet.end());
    return takes_setup ? UsbAnswer::kAck : UsbAnswer::kNone;
  }
  UsbData in(std::uint8_t, std::uint8_t) override {
    if (sends.empty()) {
      return {UsbAnswer::kNak, false, {}};
    }
    UsbData next = sends.front();
    sends.pop_front();
    return next;
  }
  UsbAnswer out(std::uint8_t,
                std::uint8_t,
                bool data1,
                std::span<const std::uint8_t> bytes) override {
    packets.emplace_back(data1, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    return out_answer;
  }

  bool takes_setup = true;
  UsbAnswer out_answer = UsbAnswer::kAck;
  std::deque<UsbData> sends;
  std::uint8_t last_address = 0xFF;
  std::vector<std::uint8_t> setup_packet;
  std::vector<std::pair<bool, std::vector<std::uint8_t>>> packets;
};

class ControlPipeTest : public ::testing::Test {
 protected:
  void ask(const UsbRequest& request, std::vector<std::uint8_t> data = {}) {
    pipe.request(request, std::move(data), [this](const UsbTransfer& end) { outcome = end; });
  }

  void step(int transactions) {
    for (int i = 0; i < transactions && !pipe.is_idle(); ++i) {
      pipe.step(1'000);
    }
  }

  ScriptedDevice device;
  ControlPipe pipe{device};
  std::optional<UsbTransfer> outcome;
};

TEST_F(ControlPipeTest, ReadEndsWithAShortPacketAndAnEmptyOne) {
  device.sends = {{UsbAnswer::kAck, true, std::vector<std::uint8_t>(8, 1)},
                  {UsbAnswer::kAck, false, {2}}};
  ask(kRead);
  step(4);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->end, UsbTransfer::End::kDone);
  EXPECT_EQ(outcome->bytes, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 1, 1, 2}));
  EXPECT_EQ(device.setup_packet, (std::vector<std::uint8_t>{0x80, 6, 0, 1, 0, 0, 18, 0}));
  ASSERT_EQ(device.packets.size(), 1U);
  EXPECT_TRUE(device.packets[0].first && device.packets[0].second.empty());
}

TEST_F(ControlPipeTest, RepeatedPacketIsTakenOnce) {
  device.sends = {{UsbAnswer::kAck, true, std::vector<std::uint8_t>(8, 1)},
                  {UsbAnswer::kAck, true, std::vector<std::uint8_t>(8, 1)},
                  {UsbAnswer::kAck, false, {}}};
  ask(kRead);
  step(5);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->bytes.size(), 8U);
}

TEST_F(ControlPipeTest, WriteIsCutIntoPacketsWithTogglingData) {
  device.sends = {{UsbAnswer::kAck, true, {}}};
  ask(kWrite, std::vector<std::uint8_t>(10, 3));
  step(4);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->end, UsbTransfer::End::kDone);
  ASSERT_EQ(device.packets.size(), 2U);
  EXPECT_TRUE(device.packets[0].first);
  EXPECT_EQ(device.packets[0].second.size(), 8U);
  EXPECT_FALSE(device.packets[1].first);
  EXPECT_EQ(device.packets[1].second.size(), 2U);
}

TEST_F(ControlPipeTest, StallEndsIt) {
  device.sends = {{UsbAnswer::kStall, false, {}}};
  ask(kRead);
  step(2);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->end, UsbTransfer::End::kStalled);
}

TEST_F(ControlPipeTest, GivesUpADeviceThatDoesNotAnswer) {
  device.takes_setup = false;
  ask(kRead);
  EXPECT_TRUE(pipe.step(1'000));
  EXPECT_TRUE(pipe.step(500'000'000));
  EXPECT_FALSE(outcome);
  EXPECT_FALSE(pipe.step(600'000'000));
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->end, UsbTransfer::End::kTimeout);
}

TEST_F(ControlPipeTest, TellsTheLastTransactionOfSetAddressAndSpeaksToItsAddressAfterwards) {
  ask(kSetAddress);
  EXPECT_FALSE(pipe.is_setting_address());
  step(1);
  EXPECT_EQ(device.last_address, 0);
  EXPECT_TRUE(pipe.is_setting_address());
  device.sends = {{UsbAnswer::kAck, true, {}}};
  step(1);
  EXPECT_TRUE(outcome);
  pipe.set_address(7);
  ask(kRead);
  step(1);
  EXPECT_EQ(device.last_address, 7);
}

TEST_F(ControlPipeTest, ForgetsItsTransfersOfADeviceThatIsGone) {
  ask(kRead);
  pipe.set_address(7);
  pipe.clear();
  EXPECT_TRUE(pipe.is_idle());
  EXPECT_EQ(pipe.address(), 0);
  EXPECT_FALSE(outcome);
}

}  // namespace
}  // namespace echomap::rp2040
