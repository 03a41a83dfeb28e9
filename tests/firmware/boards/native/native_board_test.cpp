// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_board.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/robot.hpp"

namespace echomap::native {
namespace {

class NativeBoardTest : public testing::Test {
 protected:
  NativeBoardTest() { board_.power_on(); }
  ~NativeBoardTest() override {
    board_.on_sent = nullptr;
    board_.on_trigger = nullptr;
  }
  NativeBoard& board_ = NativeBoard::instance();
};

TEST_F(NativeBoardTest, TimeStopsWhereItWasToldTo) {
  board_.run_until_ns(1234567);
  EXPECT_EQ(board_.now_ns(), 1234567);
  board_.run_until_ns(1000);
  EXPECT_EQ(board_.now_ns(), 1234567);
}

TEST_F(NativeBoardTest, SendsOneByteEveryByteTime) {
  std::vector<std::int64_t> at_ns;
  board_.on_sent = [&](std::uint8_t /*byte*/) { at_ns.push_back(board_.now_ns()); };
  board_.run_until_ns(100000000);
  ASSERT_GE(at_ns.size(), 20U);
  for (std::size_t i = 0; i < at_ns.size(); ++i) {
    EXPECT_EQ(at_ns[i], static_cast<std::int64_t>(i + 1) * NativeBoard::kByteNs);
  }
}

TEST_F(NativeBoardTest, ReceivesAtTheSamePaceAndLosesNothingOfALongRun) {
  const std::vector<std::uint8_t> bytes(1000, 0);
  board_.receive(bytes.data(), bytes.size());
  board_.run_until_ns(1000 * NativeBoard::kByteNs);
  EXPECT_EQ(app::devices.port.overruns(), 0);
}

TEST_F(NativeBoardTest, EdgesAreServedAtTheirTime) {
  board_.schedule_encoder_edge(true, 5000000, true, false);
  board_.schedule_encoder_edge(true, 6000000, true, true);
  board_.run_until_ns(4999999);
  EXPECT_EQ(app::devices.encoders.counts().right, 0);
  board_.run_until_ns(5000000);
  EXPECT_EQ(app::devices.encoders.counts().right, 1);
  board_.run_until_ns(6000000);
  EXPECT_EQ(app::devices.encoders.counts().right, 2);
  EXPECT_EQ(app::devices.encoders.counts().left, 0);
}

TEST_F(NativeBoardTest, PowerOnForgetsWhatWasScheduled) {
  board_.schedule_encoder_edge(false, 5000000, true, false);
  board_.set_pan_pulse_us(1500);
  board_.power_on();
  board_.run_until_ns(10000000);
  EXPECT_EQ(app::devices.encoders.counts().left, 0);
  EXPECT_EQ(board_.pan_pulse_us(), 0.0);
}

}  // namespace
}  // namespace echomap::native
