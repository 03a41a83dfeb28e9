// SPDX-License-Identifier: MIT
#include "host/mcap/chunk_builder.hpp"

#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/crc32.hpp"
#include "host/mcap/message_index.hpp"
#include "host/mcap/record_decoding.hpp"
#include "tests/host/mcap/small_file.hpp"

namespace echomap::mcap {
namespace {

using testing::ElementsAre;
using testing::Pair;

/// Three messages on two channels, not in order of time.
ChunkBuilder three_messages() {
  ChunkBuilder chunk;
  chunk.add_channel(1, {"/a", 0, "", {}});
  chunk.add_channel(2, {"/b", 0, "", {}});
  chunk.add_message({2, 0, 70, 0, bytes_of("x")});
  chunk.add_message({1, 0, 90, 0, bytes_of("y")});
  chunk.add_message({1, 1, 60, 0, bytes_of("z")});
  return chunk;
}

TEST(ChunkBuilder, HasMessagesOnceOneIsAdded) {
  ChunkBuilder chunk;
  chunk.add_schema(1, {"name", "", ""});
  EXPECT_FALSE(chunk.has_messages());
  EXPECT_FALSE(chunk.records().empty());
  chunk.add_message({1, 0, 5, 0, {}});
  EXPECT_TRUE(chunk.has_messages());
}

TEST(ChunkBuilder, TellsTheTimeOfItsFirstMessage) {
  EXPECT_EQ(three_messages().first_log_time_ns(), 70U);
}

TEST(ChunkBuilder, TellsWhereItsPartsAre) {
  Bytes out(1000);
  const ChunkIndex index = three_messages().append_to(out, 5000, Compression::kZstd, 3);
  EXPECT_EQ(index.message_start_time_ns, 60U);
  EXPECT_EQ(index.message_end_time_ns, 90U);
  EXPECT_EQ(index.chunk_offset, 5000U);
  EXPECT_EQ(out[1000], static_cast<std::uint8_t>(Opcode::kChunk));
  EXPECT_EQ(index.compression, "zstd");
  EXPECT_EQ(index.uncompressed_bytes, three_messages().records().size());
  EXPECT_EQ(1000 + index.chunk_bytes + index.message_index_bytes, out.size());
  ASSERT_EQ(index.message_index_offsets.size(), 2U);
  for (const auto& [channel_id, offset] : index.message_index_offsets) {
    const std::size_t place = offset - 5000 + 1000;
    EXPECT_EQ(out[place], static_cast<std::uint8_t>(Opcode::kMessageIndex));
    EXPECT_EQ(out[place + kRecordHeadBytes], channel_id);
  }
}

TEST(ChunkBuilder, SortsIndexesByTimeAndPointsAtTheMessages) {
  Bytes out;
  const ChunkBuilder chunk = three_messages();
  const ChunkIndex written = chunk.append_to(out, 0, Compression::kNone, 3);
  const std::size_t place = written.message_index_offsets.at(1) + kRecordHeadBytes;
  const MessageIndex index = decode_message_index(std::span(out).subspan(place, 2 + 4 + 2 * 16));
  EXPECT_THAT(index.entries, ElementsAre(Pair(60, testing::_), Pair(90, testing::_)));
  EXPECT_TRUE(points_into(index, chunk.records()));
}

TEST(ChunkBuilder, StoresItsRecordsCompressedWithTheirChecksum) {
  Bytes out;
  const ChunkBuilder chunk = three_messages();
  const ChunkIndex index = chunk.append_to(out, 0, Compression::kLz4, 3);
  const ChunkFields fields =
      decode_chunk(std::span(out).subspan(kRecordHeadBytes, index.chunk_bytes - kRecordHeadBytes));
  EXPECT_EQ(fields.uncompressed_crc, crc32_of(chunk.records()));
  EXPECT_EQ(decompress(fields.records, fields.compression, fields.uncompressed_bytes),
            chunk.records());
}

}  // namespace
}  // namespace echomap::mcap
