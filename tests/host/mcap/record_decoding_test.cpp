// SPDX-License-Identifier: MIT
#include "host/mcap/record_decoding.hpp"

#include <functional>
#include <span>

#include <gtest/gtest.h>

#include "host/mcap/crc32.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_reader.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/host/mcap/small_file.hpp"

namespace echomap::mcap {
namespace {

/// The record without its head.
std::span<const std::uint8_t> content_of(const Bytes& record) {
  return std::span(record).subspan(kRecordHeadBytes);
}

TEST(RecordDecoding, ReadsWhatIsWritten) {
  Bytes out;
  append_header(out, {"ros2", "library"});
  EXPECT_EQ(decode_header(content_of(out)), (HeaderInfo{"ros2", "library"}));
  const Schema schema{"name", "encoding", "data"};
  out.clear();
  append_schema(out, 65535, schema);
  EXPECT_EQ(decode_schema(content_of(out)), std::pair(std::uint16_t{65535}, schema));
  const ChannelInfo channel{"/t", 3, "cdr", {{"a", "1"}, {"b", "2"}}};
  out.clear();
  append_channel(out, 9, channel);
  EXPECT_EQ(decode_channel(content_of(out)), std::pair(std::uint16_t{9}, channel));
  const Attachment attachment{1, ~std::uint64_t{0}, "n", "t", bytes_of("data")};
  out.clear();
  append_attachment(out, attachment);
  EXPECT_EQ(decode_attachment(content_of(out)), attachment);
  const Metadata metadata{"n", {{"a", ""}, {"", "b"}}};
  out.clear();
  append_metadata(out, metadata);
  EXPECT_EQ(decode_metadata(content_of(out)), metadata);
}

TEST(RecordDecoding, LeavesTheBytesOfAMessageInPlace) {
  Bytes out;
  const Bytes payload = bytes_of("payload");
  append_message(out, {1, 2, 3, 4, payload});
  const MessageFields message = decode_message(content_of(out));
  EXPECT_EQ(message.data.data(), out.data() + out.size() - payload.size());
  EXPECT_EQ(message.data.size(), payload.size());
}

TEST(RecordDecoding, ReadsAChunk) {
  Bytes out;
  {
    RecordWriter record(out, Opcode::kChunk);
    record.number(std::uint64_t{1});
    record.number(std::uint64_t{2});
    record.number(std::uint64_t{3});
    record.number(std::uint32_t{4});
    record.text("zstd");
    record.number(std::uint64_t{5});
    record.bytes(bytes_of("12345"));
  }
  const ChunkFields chunk = decode_chunk(content_of(out));
  EXPECT_EQ(chunk.uncompressed_bytes, 3U);
  EXPECT_EQ(chunk.uncompressed_crc, 4U);
  EXPECT_EQ(chunk.compression, "zstd");
  EXPECT_EQ(Bytes(chunk.records.begin(), chunk.records.end()), bytes_of("12345"));
}

TEST(RecordDecoding, IgnoresFieldsThatWereAddedLater) {
  Bytes out;
  append_header(out, {"ros2", "library"});
  out.resize(out.size() + 10);
  EXPECT_EQ(decode_header(content_of(out)), (HeaderInfo{"ros2", "library"}));
}

TEST(RecordDecoding, RefusesEveryRecordThatIsTooShort) {
  Bytes out;
  append_channel(out, 9, {"/t", 3, "cdr", {{"a", "1"}}});
  for (std::size_t size = 0; size < content_of(out).size(); ++size) {
    EXPECT_THROW(decode_channel(content_of(out).first(size)), RecordError);
  }
  out.clear();
  append_attachment(out, {1, 2, "n", "t", bytes_of("data")});
  for (std::size_t size = 0; size < content_of(out).size(); ++size) {
    EXPECT_THROW(decode_attachment(content_of(out).first(size)), RecordError);
  }
  EXPECT_THROW(decode_data_end(Bytes(3)), RecordError);
}

TEST(RecordDecoding, VerifiesTheChecksumOfAnAttachmentThatHasOne) {
  Bytes out;
  append_attachment(out, {1, 2, "n", "t", bytes_of("data")});
  out.back() ^= 1U;
  EXPECT_THROW(decode_attachment(content_of(out)), RecordError);
  overwrite_number(out, out.size() - 4, std::uint32_t{0});
  EXPECT_EQ(decode_attachment(content_of(out)).data, bytes_of("data"));
}

}  // namespace
}  // namespace echomap::mcap
