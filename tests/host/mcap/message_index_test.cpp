// SPDX-License-Identifier: MIT
#include "host/mcap/message_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_reader.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/host/mcap/small_file.hpp"

namespace echomap::mcap {
namespace {

using testing::ElementsAre;
using testing::Pair;

/// Two messages of channel 3, at log times 50 and 60; `second_place` is that of the second.
struct IndexedChunk {
  IndexedChunk() {
    append_message(records, {3, 0, 50, 50, bytes_of("first")});
    second_place = records.size();
    append_message(records, {3, 1, 60, 60, bytes_of("second")});
  }
  Bytes records;
  std::uint64_t second_place = 0;
};

Bytes index_content(const MessageIndex& index) {
  Bytes content;
  append_number(content, index.channel_id);
  append_number(content, static_cast<std::uint32_t>(16 * index.entries.size()));
  for (const auto& [log_time_ns, place] : index.entries) {
    append_number(content, log_time_ns);
    append_number(content, place);
  }
  return content;
}

TEST(MessageIndex, ReadsItsEntries) {
  const MessageIndex index = decode_message_index(index_content({3, {{50, 0}, {60, 99}}}));
  EXPECT_EQ(index.channel_id, 3U);
  EXPECT_THAT(index.entries, ElementsAre(Pair(50, 0), Pair(60, 99)));
}

TEST(MessageIndex, RefusesEntriesThatDoNotFillIt) {
  Bytes content = index_content({3, {{50, 0}}});
  content.push_back(0);
  EXPECT_THROW(decode_message_index(content), RecordError);
  content.resize(content.size() - 2);
  EXPECT_THROW(decode_message_index(content), RecordError);
  EXPECT_THROW(decode_message_index(Bytes(5)), RecordError);
}

TEST(MessageIndex, PointsAtMessagesOfItsChannelAndTime) {
  const IndexedChunk chunk;
  EXPECT_TRUE(points_into({3, {{50, 0}, {60, chunk.second_place}}}, chunk.records));
  EXPECT_FALSE(points_into({4, {{50, 0}}}, chunk.records));
  EXPECT_FALSE(points_into({3, {{51, 0}}}, chunk.records));
  EXPECT_FALSE(points_into({3, {{50, 1}}}, chunk.records));
  EXPECT_FALSE(points_into({3, {{50, chunk.records.size()}}}, chunk.records));
  EXPECT_FALSE(points_into({3, {{50, 0}, {60, 0}}}, chunk.records));
  EXPECT_FALSE(points_into({3, {}}, chunk.records));
}

TEST(MessageIndex, IsRecognizedByWhatItPointsAt) {
  const IndexedChunk chunk;
  EXPECT_TRUE(is_index_into(index_content({3, {{60, chunk.second_place}}}), chunk.records));
  EXPECT_FALSE(is_index_into(index_content({3, {{60, 0}}}), chunk.records));
  EXPECT_FALSE(is_index_into(bytes_of("a message"), chunk.records));
}

}  // namespace
}  // namespace echomap::mcap
