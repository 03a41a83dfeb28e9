// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_board.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/robot.hpp"

namespace echomap::native {
namespace {

class NativeBoardTest : public testing::Test {
 protected:
  NativeBoardTest() { board.power_on(); }
  ~NativeBoardTest() override {
    board.on_sent = nullptr;
    board.on_trigger = nullptr;
  }
  NativeBoard& board = NativeBoard::instance();
};

TEST_F(NativeBoardTest, TimeStopsWhereItWasToldTo) {
  board.run_until_ns(1234567);
  EXPECT_EQ(board.now_ns(), 1234567);
  board.run_until_ns(1000);
  EXPECT_EQ(board.now_ns(), 1234567);
}

TEST_F(NativeBoardTest, SendsOneByteEveryByteTime) {
  std::vector<std::int64_t> at_ns;
  board.on_sent = [&](std::uint8_t /*byte*/) { at_ns.push_back(board.now_ns()); };
  board.run_until_ns(100000000);
  ASSERT_GE(at_ns.size(), 20U);
  for (std::size_t i = 0; i < at_ns.size(); ++i) {
    EXPECT_EQ(at_ns[i], static_cast<std::int64_t>(i + 1) * NativeBoard::kByteNs);
  }
}

TEST_F(NativeBoardTest, ReceivesAtTheSamePaceAndLosesNothingOfALongRun) {
  const std::vector<std::uint8_t> bytes(1000, 0);
  board.receive(bytes.data(), bytes.size());
  board.run_until_ns(1000 * NativeBoard::kByteNs);
  EXPECT_EQ(app::devices.port.overruns(), 0);
}

TEST_F(NativeBoardTest, EdgesAreServedAtTheirTime) {
  board.schedule_encoder_edge(true, 5000000, true, false);
  board.schedule_encoder_edge(true, 6000000, true, true);
  board.run_until_ns(4999999);
  EXPECT_EQ(app::devices.encoders.counts().right, 0);
  board.run_until_ns(5000000);
  EXPECT_EQ(app::devices.encoders.counts().right, 1);
  board.run_until_ns(6000000);
  EXPECT_EQ(app::devices.encoders.counts().right, 2);
  EXPECT_EQ(app::devices.encoders.counts().left, 0);
}

TEST_F(NativeBoardTest, BoardsThatTakeTurnsKeepTheirPrograms) {
  board.schedule_encoder_edge(true, 5000000, true, false);
  board.run_until_ns(6000000);
  {
    NativeBoard other;
    other.power_on();
    EXPECT_EQ(&NativeBoard::instance(), &other);
    other.run_until_ns(2000000);
    EXPECT_EQ(app::devices.encoders.counts().right, 0);
    board.run_until_ns(7000000);
    EXPECT_EQ(&NativeBoard::instance(), &board);
    EXPECT_EQ(app::devices.encoders.counts().right, 1);
    other.run_until_ns(3000000);
    EXPECT_EQ(app::devices.encoders.counts().right, 0);
    EXPECT_EQ(other.starts(), 1);
  }
  EXPECT_EQ(&NativeBoard::instance(), &board) << "the other one is gone";
  board.run_until_ns(8000000);
  EXPECT_EQ(app::devices.encoders.counts().right, 1);
}

TEST_F(NativeBoardTest, PowerOnForgetsWhatWasScheduled) {
  board.schedule_encoder_edge(false, 5000000, true, false);
  board.set_pan_pulse_us(1500);
  board.power_on();
  board.run_until_ns(10000000);
  EXPECT_EQ(app::devices.encoders.counts().left, 0);
  EXPECT_EQ(board.pan_pulse_us(), 0.0);
}

TEST_F(NativeBoardTest, AResetStartsTheProgramAnewWhileTimeGoesOn) {
  board.schedule_encoder_edge(true, 5000000, true, false);
  board.run_until_ns(7000000);
  board.reset();
  EXPECT_EQ(board.now_ns(), 7000000);
  EXPECT_EQ(board.program_ns(), 0);
  EXPECT_EQ(board.starts(), 2);
  EXPECT_EQ(app::devices.encoders.counts().right, 0);
  int sent = 0;
  board.on_sent = [&](std::uint8_t /*byte*/) { ++sent; };
  board.run_until_ns(107000000);
  EXPECT_GE(sent, 20) << "it says that it is there";
}

}  // namespace
}  // namespace echomap::native
