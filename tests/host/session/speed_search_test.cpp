// SPDX-License-Identifier: MIT
#include "host/session/speed_search.hpp"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/robot_link/fake_robot.hpp"

namespace echomap::session {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// A robot that speaks and understands at one speed only; at others both sides hear noise.
class OneSpeedStream final : public transport::ByteStream {
 public:
  explicit OneSpeedStream(int robot_baud) : robot_baud_(robot_baud) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds wait) override {
    std::vector<std::uint8_t> bytes;
    if (steady_clock::now() >= wakes_at) {
      bytes = robot.take_outgoing();
    }
    if (bytes.empty()) {
      std::this_thread::sleep_for(std::min(wait, std::chrono::microseconds(1000)));
    }
    std::transform(bytes.begin(), bytes.end(), into.begin(), [this](std::uint8_t byte) {
      return static_cast<std::uint8_t>(fits() ? byte : 0x55 ^ byte >> 1);
    });
    return bytes.size();
  }
  void write(std::span<const std::uint8_t> bytes) override {
    if (fits() && steady_clock::now() >= wakes_at) {
      robot.receive(bytes);
    }
  }
  bool set_baud(int to) override {
    baud = has_speed ? to : 0;
    tried.push_back(to);
    return has_speed;
  }
  transport::StreamStatus status() const override { return transport::StreamStatus::kOpen; }
  std::string close_reason() const override { return ""; }
  std::string name() const override { return "line"; }

  robot_link::FakeRobot robot;
  steady_clock::time_point wakes_at;
  bool has_speed = true;
  int baud = 0;
  std::vector<int> tried;

 private:
  bool fits() const { return baud == robot_baud_; }

  int robot_baud_;
};

TEST(SpeedSearch, FindsARobotAtEachSpeedThatThereIsAnImageFor) {
  for (const int baud : kRobotBauds) {
    OneSpeedStream line(baud);
    EXPECT_EQ(find_speed(line, 7), baud);
    EXPECT_EQ(line.baud, baud);
    EXPECT_EQ(line.robot.hellos, 1);
  }
}

TEST(SpeedSearch, AsksARobotOfTheUsualSpeedOnceAndWaitsForNothing) {
  OneSpeedStream line(250000);
  const auto start = steady_clock::now();
  EXPECT_EQ(find_speed(line, 7), 250000);
  EXPECT_LT(steady_clock::now() - start, milliseconds(50));
  EXPECT_EQ(line.tried, std::vector<int>{250000});
}

TEST(SpeedSearch, WaitsForABoardThatIsStillInItsBootLoader) {
  OneSpeedStream line(115200);
  line.wakes_at = steady_clock::now() + milliseconds(700);
  EXPECT_EQ(find_speed(line, 7), 115200);
}

TEST(SpeedSearch, FindsARobotThatAnotherProgramHolds) {
  OneSpeedStream line(500000);
  line.robot.hear_of_another(protocol::Hello{1, 3, 0, 99});
  EXPECT_EQ(find_speed(line, 7), 500000);
  EXPECT_EQ(line.robot.session(), 99);
}

TEST(SpeedSearch, LeavesTheUsualSpeedWhereNobodyAnswers) {
  OneSpeedStream line(9600);
  EXPECT_EQ(find_speed(line, 7, milliseconds(350)), std::nullopt);
  EXPECT_EQ(line.baud, 250000);
}

TEST(SpeedSearch, AsksNobodyWhereALineHasNoSpeed) {
  OneSpeedStream line(0);
  line.has_speed = false;
  EXPECT_EQ(find_speed(line, 7), std::nullopt);
  EXPECT_EQ(line.robot.hellos, 0);
}

}  // namespace
}  // namespace echomap::session
