// SPDX-License-Identifier: MIT
#include "protocol/frame_decoder.hpp"

#include <algorithm>
#include <ostream>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/protocol/frames.hpp"
#include "tests/support/golden_vectors.hpp"

namespace echomap::protocol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Status = DecodeStatus;

const Bytes odometry_frame = frame_of(Odometry{1234567, 321, -256, 3}, 7);
const Bytes stop_frame = frame_of(Stop{17}, 8);
const Bytes ping_frame = frame_of(Ping{0x12345678}, 9);

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes bytes;
  for (const Bytes& part : parts) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  return bytes;
}

Bytes with_flipped_bit(Bytes bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
  return bytes;
}

Bytes without(Bytes bytes, std::size_t at) {
  bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
  return bytes;
}

// --- one outcome each

TEST(FrameDecoder, TakesAFrameAndSaysNothingBeforeItsEnd) {
  FrameDecoder decoder(AllMessages::find_schema);
  for (std::size_t i = 0; i + 1 < stop_frame.size(); ++i) {
    ASSERT_EQ(decoder.take(stop_frame[i]), Status::kIncomplete);
  }
  EXPECT_EQ(decoder.take(stop_frame.back()), Status::kFrame);
}

TEST(FrameDecoder, PassesOverDelimitersInARow) {
  EXPECT_THAT(outcomes({0, 0, 0}), IsEmpty());
  EXPECT_THAT(outcomes(joined({{0, 0}, stop_frame, {0, 0}, ping_frame, {0}})),
              ElementsAre(Status::kFrame, Status::kFrame));
}

TEST(FrameDecoder, RefusesWhatIsLongerThanAnyFrame) {
  EXPECT_THAT(outcomes(joined({Bytes(200, 0x55), {0}, stop_frame})),
              ElementsAre(Status::kTooLong, Status::kFrame));
}

TEST(FrameDecoder, RefusesABlockOneByteTooLong) {
  const auto block_of = [](std::uint8_t size) {
    Bytes wire(size + 2U, 0x55);
    wire.front() = static_cast<std::uint8_t>(size + 1);
    wire.back() = 0;
    return wire;
  };
  EXPECT_THAT(outcomes(block_of(kMaxPayload + 4)), ElementsAre(Status::kUnknownId));
  EXPECT_THAT(outcomes(block_of(kMaxPayload + 5)), ElementsAre(Status::kTooLong));
}

TEST(FrameDecoder, RefusesADelimiterInsideARun) {
  for (std::size_t keep = 1; keep + 1 < ping_frame.size(); ++keep) {
    Bytes cut(ping_frame.begin(), ping_frame.begin() + static_cast<std::ptrdiff_t>(keep));
    EXPECT_THAT(outcomes(joined({cut, {0}, stop_frame})),
                ElementsAre(Status::kTruncated, Status::kFrame))
        << keep;
  }
}

TEST(FrameDecoder, RefusesABlockWithoutRoomForIdSequenceAndCrc) {
  EXPECT_THAT(outcomes({0x01, 0x00}), ElementsAre(Status::kTruncated));
  EXPECT_THAT(outcomes({0x04, Stop::kId, 0x01, 0x01, 0x00}), ElementsAre(Status::kTruncated));
}

TEST(FrameDecoder, RefusesAnIdThatIsNotItsReceivers) {
  FrameDecoder robot(MessagesToRobot::find_schema);
  EXPECT_THAT(outcomes(robot, joined({odometry_frame, stop_frame})),
              ElementsAre(Status::kUnknownId, Status::kFrame));
}

TEST(FrameDecoder, RefusesAnotherLengthThanTheIds) {
  const Bytes short_stop{0x05, Stop::kId, 0x01, 0x01, 0x01, 0x00};
  const Bytes long_stop{0x07, Stop::kId, 0x01, 0x01, 0x01, 0x01, 0x01, 0x00};
  EXPECT_THAT(outcomes(short_stop), ElementsAre(Status::kWrongLength));
  EXPECT_THAT(outcomes(long_stop), ElementsAre(Status::kWrongLength));
}

struct OtherStop {
  enum : std::uint8_t { kId = Stop::kId };
  static constexpr const char* name() { return "Stop"; }
  std::uint8_t command_number;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("command_number", m.command_number);
  }
};

TEST(FrameDecoder, RefusesTheSameIdOfAnotherSchemaByItsSeed) {
  EXPECT_THAT(outcomes(frame_of(OtherStop{17}, 8)), ElementsAre(Status::kBadCrc));
}

TEST(FrameDecoder, CallsEveryStatusButTheFirstTwoAnError) {
  EXPECT_FALSE(FrameDecoder::is_error(Status::kIncomplete));
  EXPECT_FALSE(FrameDecoder::is_error(Status::kFrame));
  for (const Status status : {Status::kTooLong,
                              Status::kTruncated,
                              Status::kUnknownId,
                              Status::kWrongLength,
                              Status::kBadCrc}) {
    EXPECT_TRUE(FrameDecoder::is_error(status));
  }
}

// --- what a fault costs

TEST(FrameDecoder, RejectsEverySingleBitErrorInEveryGoldenFrame) {
  for (const tests::GoldenFrame& golden : tests::load_golden_vectors().frames) {
    ASSERT_THAT(outcomes(golden.bytes), ElementsAre(Status::kFrame));
    for (std::size_t bit = 0; bit < golden.bytes.size() * 8; ++bit) {
      const Bytes damaged = joined({with_flipped_bit(golden.bytes, bit), {0}});
      ASSERT_THAT(outcomes(damaged), testing::Not(testing::Contains(Status::kFrame)))
          << golden.message << " bit " << bit << ": " << tests::to_hex(damaged);
    }
  }
}

/// The sequence numbers of the frames that the decoder takes out of `bytes`.
std::vector<int> taken(const Bytes& bytes) {
  FrameDecoder decoder(AllMessages::find_schema);
  std::vector<int> seqs;
  for (const std::uint8_t byte : bytes) {
    if (decoder.take(byte) == Status::kFrame) {
      seqs.push_back(decoder.frame().seq);
    }
  }
  return seqs;
}

/// Puts the damaged middle frame (seq 8) between others; the neighbour is the one after it.
void expect_only_frame_and_neighbour_lost(const Bytes& damaged, const std::string& fault) {
  const Bytes after = frame_of(Pong{1, 2}, 10);
  const std::vector<int> seqs = taken(joined({odometry_frame, damaged, ping_frame, after}));
  EXPECT_THAT(seqs, testing::AnyOf(ElementsAre(7, 9, 10), ElementsAre(7, 10))) << fault;
}

TEST(FrameDecoder, OneWrongByteCostsAtMostItsFrameAndTheNext) {
  for (std::size_t at = 0; at < stop_frame.size(); ++at) {
    for (unsigned value = 0; value <= 0xFF; ++value) {
      Bytes damaged = stop_frame;
      damaged[at] = static_cast<std::uint8_t>(value);
      if (damaged != stop_frame) {
        expect_only_frame_and_neighbour_lost(
            damaged, "byte " + std::to_string(at) + " = " + std::to_string(value));
      }
    }
  }
}

TEST(FrameDecoder, OneLostByteCostsAtMostItsFrameAndTheNext) {
  for (std::size_t at = 0; at < stop_frame.size(); ++at) {
    expect_only_frame_and_neighbour_lost(without(stop_frame, at),
                                         "lost byte " + std::to_string(at));
  }
}

TEST(FrameDecoder, OneByteTooManyCostsAtMostItsFrameAndTheNext) {
  for (std::size_t at = 0; at < stop_frame.size(); ++at) {
    for (unsigned value = 1; value <= 0xFF; ++value) {
      Bytes damaged = stop_frame;
      damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(at),
                     static_cast<std::uint8_t>(value));
      expect_only_frame_and_neighbour_lost(
          damaged, "extra byte " + std::to_string(value) + " at " + std::to_string(at));
    }
  }
}

TEST(FrameDecoder, ADelimiterFirstSavesTheFrameAfterAnyNoise) {
  std::mt19937 generator(3);
  FrameDecoder decoder(AllMessages::find_schema);
  for (int i = 0; i < 5000; ++i) {
    Bytes noise(generator() % 100);
    std::generate(
        noise.begin(), noise.end(), [&] { return static_cast<std::uint8_t>(generator()); });
    const std::vector<Status> statuses = outcomes(decoder, joined({noise, {0}, stop_frame}));
    ASSERT_EQ(statuses.back(), Status::kFrame);
    ASSERT_EQ(decoder.frame().seq, 8);
  }
}

TEST(FrameDecoder, TakesFramesInPiecesOfAnySize) {
  const Bytes stream = joined({odometry_frame, stop_frame, ping_frame});
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    FrameDecoder decoder(AllMessages::find_schema);
    const auto middle = stream.begin() + static_cast<std::ptrdiff_t>(cut);
    const std::size_t frames = outcomes(decoder, {stream.begin(), middle}).size() +
                               outcomes(decoder, {middle, stream.end()}).size();
    EXPECT_EQ(frames, 3U);
  }
}

}  // namespace
}  // namespace echomap::protocol
