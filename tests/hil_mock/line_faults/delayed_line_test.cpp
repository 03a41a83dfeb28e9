// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/delayed_line.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::line_faults {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t kByteNs = 86'805;

DelayedLine line_with(const DelayParams& params) {
  return {params, world::NoiseStream(1, world::NoisePurpose::kLineDelays)};
}

TEST(DelayedLine, HandsOnEachByteAfterTheDelay) {
  DelayParams params;
  params.shortest_us = 8'000;
  DelayedLine line = line_with(params);
  EXPECT_FALSE(line.next_arrival_ns());
  const Bytes frame{3, 1, 2, 0};
  std::int64_t now_ns = 1'000'000;
  for (const std::uint8_t byte : frame) {
    line.send(byte, now_ns);
    now_ns += kByteNs;
  }
  EXPECT_EQ(line.next_arrival_ns(), 9'000'000);
  EXPECT_TRUE(line.take_arrived(8'999'999).empty());
  EXPECT_EQ(line.take_arrived(9'000'000 + kByteNs), (Bytes{3, 1}));
  EXPECT_EQ(line.take_arrived(20'000'000), (Bytes{2, 0}));
  EXPECT_FALSE(line.next_arrival_ns());
}

TEST(DelayedLine, DrawsOneDelayForAFrameAndOvertakesNothing) {
  DelayParams params;
  params.exponential_us = 6'000.0;
  params.stall_share = 0.05;
  params.stall_us = 150'000;
  DelayedLine line = line_with(params);
  std::int64_t longest_ns = 0;
  std::int64_t now_ns = 0;
  Bytes sent;
  Bytes arrived;
  for (int frame = 0; frame < 1000; ++frame) {
    const Bytes bytes{3, static_cast<std::uint8_t>(frame % 200 + 1), 7, 0};
    for (const std::uint8_t byte : bytes) {
      now_ns += kByteNs;
      line.send(byte, now_ns);
      sent.push_back(byte);
    }
    longest_ns = std::max(longest_ns, *line.next_arrival_ns() - now_ns);
    now_ns += 10'000'000;
    for (const std::uint8_t byte : line.take_arrived(now_ns)) {
      arrived.push_back(byte);
    }
  }
  const Bytes rest = line.take_arrived(now_ns + 1'000'000'000);
  arrived.insert(arrived.end(), rest.begin(), rest.end());
  EXPECT_EQ(arrived, sent);
  EXPECT_GT(longest_ns, 140'000'000) << "a stall is seen";
}

TEST(DelayedLine, ModelsHaveNames) {
  EXPECT_EQ(line_delays("ftdi").to_host.poll_us, 16'000);
  EXPECT_EQ(line_delays("ftdi").to_robot.poll_us, 1'000);
  EXPECT_EQ(line_delays("usb").to_host.poll_us, 1'000);
  EXPECT_EQ(line_delays("bluetooth").to_robot.stall_us, 150'000);
  EXPECT_THROW(line_delays("carrier pigeon"), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::line_faults
