// SPDX-License-Identifier: MIT
#include "host/robot_link/foreign_frames.hpp"

#include <gtest/gtest.h>

#include "protocol/frame_encoder.hpp"
#include "tests/host/robot_link/other_messages.hpp"

namespace echomap::robot_link {
namespace {

const SchemaDifference& newer() {
  static const SchemaDifference difference(
      read_robot_schema(description_of<other_messages::Newer>()).value());
  return difference;
}

template <class M>
std::vector<std::uint8_t> frame_of(const M& message, std::uint8_t seq) {
  protocol::FrameEncoder encoder;
  const protocol::ByteSpan frame = encoder.encode(message, seq);
  return {frame.data, frame.data + frame.size};
}

std::optional<std::uint8_t> recognised(const std::vector<std::uint8_t>& bytes) {
  ForeignFrames frames;
  for (const std::uint8_t byte : bytes) {
    frames.add(byte);
  }
  return frames.recognised(newer());
}

TEST(ForeignFrames, RecognisesWhatTheRobotHasDescribed) {
  EXPECT_EQ(recognised(frame_of(Compass{1, 2}, 77)), 77);
}

TEST(ForeignFrames, TakesADamagedOneForNone) {
  const auto frame = frame_of(Compass{100'000, -2}, 77);
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) {
    auto damaged = frame;
    damaged[i] ^= 0x10U;
    EXPECT_FALSE(recognised(damaged)) << i;
  }
  auto cut = frame;
  cut.erase(cut.begin() + 3);
  EXPECT_FALSE(recognised(cut));
}

TEST(ForeignFrames, LeavesOurOwnAlone) {
  EXPECT_FALSE(recognised(frame_of(protocol::Odometry{1, 2, 3, 4}, 5)));
  EXPECT_FALSE(recognised({}));
  EXPECT_FALSE(recognised({0}));
}

TEST(ForeignFrames, BeginsAnewAfterEachDelimiter) {
  auto bytes = std::vector<std::uint8_t>(1000, 0x55);
  bytes.push_back(0);
  const auto frame = frame_of(Compass{1, 2}, 9);
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  EXPECT_EQ(recognised(bytes), 9);
}

}  // namespace
}  // namespace echomap::robot_link
