// SPDX-License-Identifier: MIT
#include "host/mcap/mcap_reader.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/chunk_compression.hpp"
#include "host/mcap/crc32.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

/// Magic and header, as files by any writer begin.
Bytes beginning() {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append_header(bytes, {"ros2", "somebody's library"});
  return bytes;
}

/// The records of a chunk or of a file without chunks: schema 1, channel 3 and two messages.
Bytes loose_records() {
  Bytes bytes;
  append_schema(bytes, 1, {"std_msgs/msg/String", "ros2msg", "string data"});
  append_channel(bytes, 3, {"/log", 1, "cdr", {}});
  const Bytes first = bytes_of("first");
  const Bytes second = bytes_of("second");
  append_message(bytes, {3, 10, 100, 101, first});
  append_message(bytes, {3, 11, 90, 91, second});
  return bytes;
}

/// What a chunk says of its records; what is not given is as it should be.
struct ChunkClaims {
  std::string compression = "lz4";
  std::uint64_t uncompressed_bytes = 0;
  std::uint32_t crc = 0;
};

void append_foreign_chunk(Bytes& out, const ChunkClaims& claims, const Bytes& stored) {
  RecordWriter record(out, Opcode::kChunk);
  record.number(std::uint64_t{90});
  record.number(std::uint64_t{100});
  record.number(claims.uncompressed_bytes);
  record.number(claims.crc);
  record.text(claims.compression);
  record.number(std::uint64_t{stored.size()});
  record.bytes(stored);
}

void append_bytes(Bytes& out, const Bytes& bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

class McapReaderTest : public testing::Test {
 protected:
  fs::path path() const { return folder_ / "run.mcap"; }
  /// All that is read of a file with these bytes.
  ReadOut read(const Bytes& bytes) const {
    save_bytes(path(), bytes);
    return read_out(path());
  }
  const std::vector<std::string> loose_lines_{"/log 10 100 101 first", "/log 11 90 91 second"};

 private:
  tests::ScratchFolder folder_;
};

TEST_F(McapReaderTest, HandsOutEveryField) {
  write_small_file(path());
  McapReader reader(path());
  EXPECT_EQ(reader.header(), (HeaderInfo{"ros2", "echomap test"}));
  const auto metadata = reader.next();
  ASSERT_TRUE(metadata && std::holds_alternative<Metadata>(*metadata));
  const auto record = reader.next();
  ASSERT_TRUE(record && std::holds_alternative<Message>(*record));
  const Channel& channel = *std::get<Message>(*record).channel;
  EXPECT_EQ(channel.info, (ChannelInfo{"/log", 1, "cdr", {{"qos", "reliable"}}}));
  ASSERT_NE(channel.schema, nullptr);
  EXPECT_EQ(*channel.schema, (Schema{"std_msgs/msg/String", "ros2msg", "string data\n"}));
}

TEST_F(McapReaderTest, EndsAfterTheDataSection) {
  write_small_file(path());
  McapReader reader(path());
  EXPECT_LT(reader.progress(), 0.5);
  while (reader.next()) {
  }
  EXPECT_FALSE(reader.next());
  EXPECT_GT(reader.progress(), 0.4);
  EXPECT_LE(reader.progress(), 1.0);
}

TEST_F(McapReaderTest, ReadsAFileWithoutChunks) {
  Bytes bytes = beginning();
  append_bytes(bytes, loose_records());
  append_data_end(bytes, 0);
  const ReadOut out = read(bytes);
  EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_));
  EXPECT_EQ(out.error, "");
}

TEST_F(McapReaderTest, ReadsChunksWithoutChecksumsInEachCompression) {
  const Bytes records = loose_records();
  for (const auto compression : {Compression::kNone, Compression::kZstd, Compression::kLz4}) {
    Bytes bytes = beginning();
    append_foreign_chunk(
        bytes, {name_of(compression), records.size(), 0}, compress(records, compression, 1));
    append_data_end(bytes, 0);
    const ReadOut out = read(bytes);
    EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_)) << name_of(compression);
    EXPECT_EQ(out.error, "");
  }
}

TEST_F(McapReaderTest, SkipsRecordsThatItDoesNotKnow) {
  Bytes bytes = beginning();
  { RecordWriter(bytes, static_cast<Opcode>(0x80)).bytes(Bytes(10000, 1)); }
  append_bytes(bytes, loose_records());
  append_data_end(bytes, crc32_of(bytes));
  const ReadOut out = read(bytes);
  EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_));
  EXPECT_EQ(out.error, "");
}

TEST_F(McapReaderTest, TakesEqualDefinitionsAgainAndIgnoresSchemaZero) {
  Bytes bytes = beginning();
  append_bytes(bytes, loose_records());
  append_schema(bytes, 0, {"nothing", "", ""});
  append_bytes(bytes, loose_records());
  append_data_end(bytes, 0);
  EXPECT_EQ(read(bytes).lines.size(), 4U);
  EXPECT_EQ(read(bytes).error, "");
}

TEST_F(McapReaderTest, SaysWhatIsNoMcapFile) {
  const auto error_of = [](const fs::path& file) {
    return tests::thrown_text<files::FileError>([&] { McapReader reader(file); });
  };
  save_bytes(path(), bytes_of("x_m,y_m,heading_rad\n"));
  EXPECT_THAT(error_of(path()), EndsWith("run.mcap: not an MCAP file"));
  save_bytes(path(), {});
  EXPECT_THAT(error_of(path()), EndsWith("run.mcap: not an MCAP file"));
  EXPECT_THAT(error_of("/nowhere/run.mcap"),
              HasSubstr("/nowhere/run.mcap: No such file or directory"));
  EXPECT_THAT(error_of("/tmp"), HasSubstr("cannot read /tmp: Is a directory"));
}

TEST_F(McapReaderTest, RefusesAFileThatDoesNotBeginWithAHeader) {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append_metadata(bytes, {"m", {}});
  EXPECT_THAT(read(bytes).error, EndsWith("run.mcap: byte 8: the first record is not a header"));
}

TEST_F(McapReaderTest, OpensAFileThatIsCutOffInItsHeader) {
  Bytes bytes = beginning();
  bytes.resize(12);
  save_bytes(path(), bytes);
  McapReader reader(path());
  EXPECT_EQ(reader.header(), HeaderInfo{});
  EXPECT_THROW(reader.next(), CutOffFile);
  EXPECT_THROW(reader.next(), CutOffFile);
}

TEST_F(McapReaderTest, WarnsOfAFileWhoseWriterWasKilled) {
  Bytes bytes = beginning();
  append_bytes(bytes, loose_records());
  const ReadOut out = read(bytes);
  EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_));
  EXPECT_TRUE(out.is_cut_off);
  EXPECT_THAT(out.error, HasSubstr("byte " + std::to_string(bytes.size()) + ": the file ends"));
  EXPECT_THAT(out.error, HasSubstr("everything before it was read"));
}

TEST_F(McapReaderTest, NamesTheByteOfAMessageOfAnUnknownChannel) {
  Bytes bytes = beginning();
  append_bytes(bytes, loose_records());
  const std::size_t place = bytes.size();
  append_message(bytes, {4, 0, 0, 0, {}});
  const ReadOut out = read(bytes);
  EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_));
  EXPECT_FALSE(out.is_cut_off);
  EXPECT_THAT(out.error,
              EndsWith("byte " + std::to_string(place) + ": a message of the unknown channel 4"));
}

TEST_F(McapReaderTest, HandsOutWhatIsBeforeTheDamageInAChunkWithoutChecksum) {
  Bytes records = loose_records();
  append_message(records, {9, 0, 0, 0, {}});
  Bytes bytes = beginning();
  const std::size_t place = bytes.size();
  append_foreign_chunk(bytes, {"", records.size(), 0}, records);
  append_data_end(bytes, 0);
  const ReadOut out = read(bytes);
  EXPECT_THAT(out.lines, ElementsAreArray(loose_lines_));
  EXPECT_THAT(out.error,
              HasSubstr("byte " + std::to_string(place) + ": in the chunk, at its byte"));
}

TEST_F(McapReaderTest, NoticesWrongChecksums) {
  const Bytes records = loose_records();
  Bytes chunk = beginning();
  append_foreign_chunk(chunk, {"", records.size(), crc32_of(records) + 1}, records);
  EXPECT_THAT(read(chunk).lines, IsEmpty());
  EXPECT_THAT(read(chunk).error, EndsWith("the checksum of the chunk differs"));
  Bytes data = beginning();
  append_data_end(data, crc32_of(data) + 1);
  EXPECT_THAT(read(data).error, HasSubstr("the checksum of the data section differs"));
  Bytes attachment = beginning();
  append_attachment(attachment, {0, 0, "a\x1b[2J", "", bytes_of("data")});
  attachment[attachment.size() - 6] ^= 1U;
  EXPECT_THAT(read(attachment).error, EndsWith("the checksum of attachment 'a?[2J' differs"));
}

TEST_F(McapReaderTest, RefusesACompressionThatItDoesNotKnow) {
  Bytes bytes = beginning();
  append_foreign_chunk(bytes, {"bz2", 4, 0}, bytes_of("data"));
  EXPECT_THAT(read(bytes).error, HasSubstr("compressed by 'bz2'"));
}

TEST_F(McapReaderTest, RefusesHugeDeclaredLengths) {
  Bytes chunk = beginning();
  append_foreign_chunk(chunk, {"zstd", kMaxRecordBytes + 1, 0}, bytes_of("data"));
  EXPECT_THAT(read(chunk).error, HasSubstr("a chunk of 268435457 bytes uncompressed"));
  Bytes record = beginning();
  const std::size_t length_at = record.size() + 1;
  append_metadata(record, {"m", {}});
  overwrite_number(record, length_at, ~std::uint64_t{0});
  EXPECT_THAT(read(record).error, HasSubstr("a record of 18446744073709551615 bytes"));
  EXPECT_FALSE(read(record).is_cut_off);
  Bytes field = beginning();
  append_metadata(field, {"m", {}});
  overwrite_number(field, length_at + 8, ~std::uint32_t{0});
  EXPECT_THAT(read(field).error, HasSubstr("a field of 4294967295 bytes in a record that has"));
}

TEST_F(McapReaderTest, RefusesARecordOfMoreThan256MiB) {
  Bytes bytes = beginning();
  { RecordWriter(bytes, Opcode::kMetadata); }
  overwrite_number(bytes, bytes.size() - 8, kMaxRecordBytes + 1);
  save_bytes(path(), bytes);
  fs::resize_file(path(), bytes.size() + kMaxRecordBytes + 1);
  EXPECT_THAT(read_out(path()).error, HasSubstr("bytes; at most 268435456 are read"));
}

TEST_F(McapReaderTest, RefusesRecordsOfTheSummaryBeforeTheEndOfTheData) {
  for (const Opcode opcode : {Opcode::kInvalid, Opcode::kFooter, Opcode::kStatistics}) {
    Bytes bytes = beginning();
    { RecordWriter(bytes, opcode); }
    EXPECT_THAT(read(bytes).error, EndsWith("which does not belong into the data section"));
  }
}

TEST_F(McapReaderTest, RefusesASecondMeaningOfAnIdentifier) {
  Bytes bytes = beginning();
  append_bytes(bytes, loose_records());
  append_channel(bytes, 3, {"/other", 1, "cdr", {}});
  EXPECT_THAT(read(bytes).error, EndsWith("channel 3 is defined in two ways"));
}

}  // namespace
}  // namespace echomap::mcap
