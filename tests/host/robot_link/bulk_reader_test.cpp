// SPDX-License-Identifier: MIT
#include "host/robot_link/bulk_reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using protocol::BulkContent;
using tests::at_ms;

std::vector<std::uint8_t> counting(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  return bytes;
}

protocol::BulkData piece_of(const std::vector<std::uint8_t>& content, protocol::BulkRead read) {
  std::array<std::uint32_t, 8> words{};
  if (read.offset < content.size()) {
    std::memcpy(words.data(),
                content.data() + read.offset,
                std::min(sizeof(words), content.size() - read.offset));
  }
  protocol::BulkData data{};
  data.content = read.content;
  data.offset = read.offset;
  data.total = static_cast<std::uint16_t>(content.size());
  std::array fields{&data.word_0,
                    &data.word_1,
                    &data.word_2,
                    &data.word_3,
                    &data.word_4,
                    &data.word_5,
                    &data.word_6,
                    &data.word_7};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    *fields.at(i) = words.at(i);
  }
  return data;
}

std::vector<protocol::BulkRead> take_all(BulkReader& reader, time::HostTime now) {
  std::vector<protocol::BulkRead> reads;
  while (reader.is_due(now)) {
    reads.push_back(reader.take(now));
  }
  return reads;
}

class BulkReaderTest : public testing::Test {
 protected:
  /// Reads `content` over a line on which every answer takes 5 ms and is lost at times.
  BulkResult read(const std::vector<std::uint8_t>& content, double loss) {
    std::mt19937 random(4);
    std::vector<std::pair<int, protocol::BulkData>> under_way;
    reader.start(BulkContent::kSchema);
    for (int now_ms = 0; now_ms < 100'000; ++now_ms) {
      for (const auto& read : take_all(reader, at_ms(now_ms))) {
        if (static_cast<double>(random()) >= loss * 4294967296.0) {
          under_way.emplace_back(now_ms + 5, piece_of(content, read));
        }
      }
      while (!under_way.empty() && under_way.front().first <= now_ms) {
        reader.take_answer(under_way.front().second, at_ms(now_ms));
        under_way.erase(under_way.begin());
      }
      reader.give_up_if_exhausted(at_ms(now_ms));
      if (auto result = reader.take_result()) {
        return *result;
      }
    }
    ADD_FAILURE() << "no end";
    return {};
  }

  BulkReader reader{RetransmissionParams{}};
};

TEST_F(BulkReaderTest, ReadsContentsOfAnyLength) {
  for (const std::size_t count : {1U, 31U, 32U, 33U, 95U, 96U, 128U, 129U, 1500U, 8192U}) {
    const BulkResult result = read(counting(count), 0.0);
    EXPECT_EQ(result.status, BulkStatus::kWhole) << count;
    EXPECT_EQ(result.bytes, counting(count)) << count;
  }
}

TEST_F(BulkReaderTest, ReadsThroughALineThatLosesAFifth) {
  const BulkResult result = read(counting(1500), 0.2);
  EXPECT_EQ(result.status, BulkStatus::kWhole);
  EXPECT_EQ(result.bytes, counting(1500));
}

TEST_F(BulkReaderTest, KeepsFourPiecesOpen) {
  reader.start(BulkContent::kConfiguration);
  const auto first = take_all(reader, at_ms(0));
  ASSERT_EQ(first.size(), 4U);
  EXPECT_EQ(first[3].offset, 96);
  EXPECT_EQ(first[3].content, 1);
  reader.take_answer(piece_of(counting(1000), first[1]), at_ms(5));
  const auto next = take_all(reader, at_ms(5));
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(next[0].offset, 128);
}

TEST_F(BulkReaderTest, SaysThatTheRobotDoesNotHaveIt) {
  EXPECT_EQ(read({}, 0.0).status, BulkStatus::kNotThere);
}

TEST_F(BulkReaderTest, GivesUpWithoutAnswers) {
  const BulkResult result = read(counting(100), 1.0);
  EXPECT_EQ(result.status, BulkStatus::kNoAnswer);
  EXPECT_TRUE(result.bytes.empty());
}

TEST_F(BulkReaderTest, RefusesAContentThatChangesItsLengthOrHasTooMuch) {
  reader.start(BulkContent::kSchema);
  const auto reads = take_all(reader, at_ms(0));
  reader.take_answer(piece_of(counting(100), reads[0]), at_ms(1));
  reader.take_answer(piece_of(counting(101), reads[1]), at_ms(1));
  EXPECT_EQ(reader.take_result()->status, BulkStatus::kInconsistent);
  EXPECT_EQ(read(counting(8193), 0.0).status, BulkStatus::kInconsistent);
}

TEST_F(BulkReaderTest, IgnoresPiecesThatNobodyAskedFor) {
  reader.take_answer(piece_of(counting(10), {0, 0}), at_ms(0));
  EXPECT_FALSE(reader.take_result());
  reader.start(BulkContent::kSchema);
  take_all(reader, at_ms(0));
  reader.take_answer(piece_of(counting(10), {1, 0}), at_ms(0));
  reader.take_answer(piece_of(counting(10), {0, 7}), at_ms(0));
  EXPECT_FALSE(reader.take_result());
  reader.take_answer(piece_of(counting(10), {0, 0}), at_ms(0));
  EXPECT_EQ(reader.take_result()->bytes, counting(10));
  EXPECT_FALSE(reader.take_result());
}

TEST_F(BulkReaderTest, EndsWhatItReadsWhenTheLinkIsLost) {
  reader.abandon();
  EXPECT_FALSE(reader.take_result());
  reader.start(BulkContent::kSchema);
  reader.abandon();
  EXPECT_EQ(reader.take_result()->status, BulkStatus::kNoAnswer);
  EXPECT_FALSE(reader.is_due(at_ms(0)));
}

TEST(BulkReader, RefusesAWindowOfNothing) {
  EXPECT_THROW(BulkReader({}, {.window = 0}), std::invalid_argument);
  EXPECT_THROW(BulkReader({}, {.tries = 0}), std::invalid_argument);
  EXPECT_THROW(BulkReader({}, {.max_bytes = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
