// SPDX-License-Identifier: MIT
#include "hil_mock/runner/faulty_board.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/fake_board.hpp"

namespace echomap::runner {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// What an echoing board sends back through a line with these faults.
Bytes echoed(const line_faults::LineFaults& faults, const Bytes& bytes) {
  FaultyBoard board(std::make_unique<FakeBoard>(), {.faults = faults});
  Bytes sent;
  board.on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  board.receive(bytes);
  board.run_until(1000);
  return sent;
}

Bytes frames(int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) {
    for (const std::uint8_t byte : Bytes{3, 1, 2, 0}) {
      bytes.push_back(byte);
    }
  }
  return bytes;
}

TEST(FaultyBoard, PassesEverythingWhereThereAreNoFaults) {
  EXPECT_EQ(echoed({}, frames(100)), frames(100));
}

TEST(FaultyBoard, LosesFramesOfBothDirections) {
  const Bytes sent = echoed({.rates = {}, .loss = 0.1, .seed = 2}, frames(10'000));
  EXPECT_NEAR(static_cast<double>(sent.size()), 0.81 * 40'000.0, 1000.0);
  EXPECT_EQ(sent, echoed({.rates = {}, .loss = 0.1, .seed = 2}, frames(10'000)));
  EXPECT_NE(sent, echoed({.rates = {}, .loss = 0.1, .seed = 3}, frames(10'000)));
}

TEST(FaultyBoard, DelaysBytesOfBothDirections) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  line_faults::DelayParams delay;
  delay.shortest_us = 8'000;
  FaultyBoard board(std::move(inner), {.delays = {{delay, delay}}});
  Bytes sent;
  board.on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  board.run_until(1'000'000);
  board.receive(frames(1));
  board.run_until(16'000'000);
  EXPECT_EQ(fake.received_at_ns, 9'000'000);
  EXPECT_EQ(board.now_ns(), 16'000'000);
  EXPECT_TRUE(sent.empty());
  board.run_until(24'000'000);
  EXPECT_EQ(sent, frames(1));
}

TEST(FaultyBoard, PassesNothingEitherWayWhileTheLineIsAway) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  FaultyBoard board(std::move(inner), {.faults = line_faults::parse_line_faults("away=1:5")});
  Bytes sent;
  board.on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  board.receive(frames(1));
  board.run_until(1'000'000'000);
  EXPECT_TRUE(sent.empty()) << "it answers when the line is away already";
  board.receive(frames(1));
  EXPECT_TRUE(fake.received.empty());
  board.run_until(6'000'000'000);
  board.receive(frames(1));
  board.run_until(6'000'000'001);
  EXPECT_EQ(sent, frames(1));
}

TEST(FaultyBoard, PassesNothingEitherWayWhileTheCableIsCut) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  FaultyBoard board(std::move(inner), {});
  Bytes sent;
  board.on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  board.receive(frames(1));
  board.cut_cable(1'000'000);
  board.run_until(500'000);
  EXPECT_TRUE(sent.empty());
  board.receive(frames(1));
  EXPECT_TRUE(fake.received.empty());
  board.cut_cable(100'000);
  board.run_until(999'999);
  board.receive(frames(1));
  EXPECT_TRUE(fake.received.empty()) << "a shorter cut does not mend it";
  board.run_until(1'000'000);
  board.receive(frames(1));
  board.run_until(1'000'001);
  EXPECT_EQ(sent, frames(1));
}

TEST(FaultyBoard, PullsThePlugOnceForTheTimeThatNothingPasses) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  FaultyBoard board(std::move(inner), {.faults = line_faults::parse_line_faults("away=1:5")});
  const auto run_to_ms = [&board](std::int64_t ms) {
    while (board.now_ns() < ms * 1'000'000) {
      board.run_until(board.now_ns() + 1'000'000);
    }
  };
  run_to_ms(1'000);
  EXPECT_EQ(fake.plugged, std::vector<bool>());
  run_to_ms(6'000);
  EXPECT_EQ(fake.plugged, std::vector<bool>{false});
  run_to_ms(7'000);
  EXPECT_EQ(fake.plugged, (std::vector<bool>{false, true}));
  board.cut_cable(1'000'000);
  run_to_ms(8'000);
  EXPECT_EQ(fake.plugged, (std::vector<bool>{false, true, false, true}));
}

TEST(FaultyBoard, ACutTakesWhatIsOnItsWay) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  line_faults::DelayParams delay;
  delay.shortest_us = 8'000;
  FaultyBoard board(std::move(inner), {.delays = {{delay, delay}}});
  Bytes sent;
  board.on_sent = [&sent](std::uint8_t byte) { sent.push_back(byte); };
  board.receive(frames(1));
  fake.on_sent(7);
  board.run_until(1'000'000);
  board.cut_cable(20'000'000);
  for (std::int64_t at_ns = 2'000'000; at_ns <= 30'000'000; at_ns += 1'000'000) {
    board.run_until(at_ns);
  }
  EXPECT_EQ(fake.received_at_ns, -1);
  EXPECT_TRUE(sent.empty());
}

TEST(FaultyBoard, HandsOnPinsAndHooks) {
  auto inner = std::make_unique<FakeBoard>();
  FakeBoard& fake = *inner;
  FaultyBoard board(std::move(inner), {.faults = {.rates = {}, .loss = 1.0, .seed = 1}});
  std::int64_t triggered_ns = 0;
  board.on_trigger = [&triggered_ns](std::int64_t at_ns) { triggered_ns = at_ns; };
  fake.on_trigger(7);
  int duties_told = 0;
  board.on_duty = [&duties_told] { ++duties_told; };
  fake.on_duty();
  EXPECT_EQ(duties_told, 1);
  board.schedule_encoder_edge(Wheel::kRight, 5, true, false);
  board.schedule_echo(10, 20);
  board.set_bump(Wheel::kLeft, true);
  fake.duty = {0.5, -0.5};
  EXPECT_EQ(triggered_ns, 7);
  EXPECT_EQ(fake.right_edges.size(), 1U);
  EXPECT_EQ(fake.echoes.size(), 1U);
  EXPECT_TRUE(fake.left_bump);
  EXPECT_EQ(board.motor_duty().right, -0.5);
  EXPECT_EQ(board.firmware_name(), "fake 1.0");
  board.reset();
  EXPECT_EQ(fake.resets, 1);
}

}  // namespace
}  // namespace echomap::runner
