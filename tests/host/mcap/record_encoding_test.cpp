// SPDX-License-Identifier: MIT
#include "host/mcap/record_encoding.hpp"

#include <gtest/gtest.h>

#include "host/mcap/crc32.hpp"
#include "tests/host/mcap/small_file.hpp"

// The bytes stand here as the specification has them.
namespace echomap::mcap {
namespace {

TEST(Crc32, IsThatOfZip) {
  EXPECT_EQ(crc32_of(bytes_of("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32_of(bytes_of("6789"), crc32_of(bytes_of("12345"))), 0xCBF43926U);
  EXPECT_EQ(crc32_of({}), 0U);
}

TEST(RecordEncoding, LaysOutAHeader) {
  Bytes out;
  append_header(out, {"ros2", "x"});
  EXPECT_EQ(out,
            (Bytes{1, 13, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 'r', 'o', 's', '2', 1, 0, 0, 0, 'x'}));
}

TEST(RecordEncoding, LaysOutASchema) {
  Bytes out;
  append_schema(out, 0x0102, {"N", "e", "dd"});
  EXPECT_EQ(out, (Bytes{3, 18,  0, 0, 0, 0, 0,   0, 0, 2, 1, 1,   0,  0,
                        0, 'N', 1, 0, 0, 0, 'e', 2, 0, 0, 0, 'd', 'd'}));
}

TEST(RecordEncoding, LaysOutAChannel) {
  Bytes out;
  append_channel(out, 7, {"/t", 3, "c", {{"k", "v"}}});
  EXPECT_EQ(out, (Bytes{4, 29, 0, 0, 0,   0,  0, 0, 0, 7, 0, 3, 0, 2,   0, 0, 0, '/', 't',
                        1, 0,  0, 0, 'c', 10, 0, 0, 0, 1, 0, 0, 0, 'k', 1, 0, 0, 0,   'v'}));
}

TEST(RecordEncoding, LaysOutAMessage) {
  Bytes out;
  append_message(out, {7, 2, 3, 0x0102030405060708, bytes_of("m")});
  EXPECT_EQ(out, (Bytes{5, 23, 0, 0, 0, 0, 0, 0, 0, 7, 0, 2, 0, 0, 0, 3,
                        0, 0,  0, 0, 0, 0, 0, 8, 7, 6, 5, 4, 3, 2, 1, 'm'}));
}

TEST(RecordEncoding, EndsAnAttachmentWithTheChecksumOfItsFields) {
  Bytes out;
  append_attachment(out, {1, 2, "n", "t", bytes_of("data")});
  ASSERT_EQ(out.size(), 9U + 16U + 5U + 5U + 12U + 4U);
  const std::span<const std::uint8_t> fields = std::span(out).subspan(9, 38);
  Bytes crc(4);
  for (std::size_t i = 0; i < 4; ++i) {
    crc[i] = static_cast<std::uint8_t>(crc32_of(fields) >> (8 * i));
  }
  EXPECT_EQ(Bytes(out.end() - 4, out.end()), crc);
}

TEST(RecordEncoding, SortsTheEntriesOfMetadata) {
  Bytes out;
  append_metadata(out, {"", {{"b", ""}, {"a", ""}}});
  EXPECT_EQ(out, (Bytes{12, 26, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0, 0,   18, 0, 0, 0, 1,
                        0,  0,  0, 'a', 0, 0, 0, 0, 1, 0, 0, 0, 'b', 0,  0, 0, 0}));
}

TEST(RecordEncoding, LaysOutTheEndOfTheData) {
  Bytes out;
  append_data_end(out, 0x01020304);
  EXPECT_EQ(out, (Bytes{15, 4, 0, 0, 0, 0, 0, 0, 0, 4, 3, 2, 1}));
}

}  // namespace
}  // namespace echomap::mcap
