// SPDX-License-Identifier: MIT
#include "host/mcap/summary.hpp"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/crc32.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/record_reader.hpp"
#include "tests/host/mcap/small_file.hpp"

namespace echomap::mcap {
namespace {

using testing::ElementsAre;

/// Where the summary of the tests begins in its file.
constexpr std::uint64_t kFileOffset = 10000;

struct SummaryRecord {
  Opcode opcode{};
  std::uint64_t offset = 0;
  std::span<const std::uint8_t> content;
};

std::vector<SummaryRecord> records_in(const Bytes& summary) {
  std::vector<SummaryRecord> records;
  RecordReader reader(std::span<const std::uint8_t>(summary).first(summary.size() - kMagic.size()));
  while (!reader.rest().empty()) {
    const std::uint64_t offset =
        kFileOffset + summary.size() - kMagic.size() - reader.rest().size();
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    records.push_back({opcode, offset, reader.bytes(reader.number<std::uint64_t>())});
  }
  return records;
}

/// One of everything but for channels, of which there are two.
Bytes whole_summary() {
  Summary summary;
  summary.add_schema({"name", "encoding", "data"});
  summary.add_channel({"/a", 1, "", {}});
  summary.add_channel({"/b", 0, "", {}});
  summary.count_message(2, 70);
  summary.count_message(2, 50);
  summary.add_chunk({});
  summary.add_attachment({});
  summary.add_metadata({});
  Bytes out;
  summary.append_to(out, kFileOffset);
  return out;
}

TEST(Summary, CountsIdentifiersFromOne) {
  Summary summary;
  EXPECT_FALSE(summary.has_channel(0));
  EXPECT_EQ(summary.add_schema({}), 1U);
  EXPECT_EQ(summary.add_schema({}), 2U);
  EXPECT_FALSE(summary.has_channel(1));
  EXPECT_EQ(summary.add_channel({"/a", 2, "", {}}), 1U);
  EXPECT_TRUE(summary.has_channel(1));
  EXPECT_THROW(summary.add_channel({"/b", 3, "", {}}), std::invalid_argument);
}

TEST(Summary, EndsWhereIdentifiersEnd) {
  Summary summary;
  for (int i = 0; i < 65535; ++i) {
    summary.add_channel({});
  }
  EXPECT_THROW(summary.add_channel({}), std::length_error);
}

TEST(Summary, GroupsItsRecordsByKind) {
  const Bytes bytes = whole_summary();
  std::vector<Opcode> kinds;
  for (const SummaryRecord& record : records_in(bytes)) {
    if (kinds.empty() || kinds.back() != record.opcode) {
      kinds.push_back(record.opcode);
    }
  }
  EXPECT_THAT(kinds,
              ElementsAre(Opcode::kSchema,
                          Opcode::kChannel,
                          Opcode::kStatistics,
                          Opcode::kChunkIndex,
                          Opcode::kAttachmentIndex,
                          Opcode::kMetadataIndex,
                          Opcode::kSummaryOffset,
                          Opcode::kFooter));
}

TEST(Summary, TellsWhereItsGroupsAre) {
  const Bytes bytes = whole_summary();
  const auto records = records_in(bytes);
  std::size_t groups = 0;
  for (const SummaryRecord& record : records) {
    if (record.opcode == Opcode::kSummaryOffset) {
      RecordReader reader(record.content);
      const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
      const auto offset = reader.number<std::uint64_t>();
      const auto length = reader.number<std::uint64_t>();
      for (const SummaryRecord& other : records) {
        const bool is_inside = other.offset >= offset && other.offset < offset + length;
        EXPECT_EQ(is_inside, other.opcode == opcode);
      }
      ++groups;
    }
  }
  EXPECT_EQ(groups, 6U);
}

TEST(Summary, CountsMessagesAndTheirTimes) {
  const Bytes bytes = whole_summary();
  const auto records = records_in(bytes);
  RecordReader reader(records.at(3).content);
  ASSERT_EQ(records.at(3).opcode, Opcode::kStatistics);
  EXPECT_EQ(reader.number<std::uint64_t>(), 2U);   // Messages.
  EXPECT_EQ(reader.number<std::uint16_t>(), 1U);   // Schemas.
  EXPECT_EQ(reader.number<std::uint32_t>(), 2U);   // Channels.
  EXPECT_EQ(reader.number<std::uint32_t>(), 1U);   // Attachments.
  EXPECT_EQ(reader.number<std::uint32_t>(), 1U);   // Metadata.
  EXPECT_EQ(reader.number<std::uint32_t>(), 1U);   // Chunks.
  EXPECT_EQ(reader.number<std::uint64_t>(), 50U);  // First log time.
  EXPECT_EQ(reader.number<std::uint64_t>(), 70U);  // Last log time.
  EXPECT_EQ(reader.number<std::uint32_t>(), 20U);  // Bytes of what follows.
  EXPECT_EQ(reader.number<std::uint16_t>(), 1U);
  EXPECT_EQ(reader.number<std::uint64_t>(), 0U);
  EXPECT_EQ(reader.number<std::uint16_t>(), 2U);
  EXPECT_EQ(reader.number<std::uint64_t>(), 2U);
}

TEST(Summary, EndsWithItsChecksumAndTheMagic) {
  const Bytes bytes = whole_summary();
  const SummaryRecord footer = records_in(bytes).back();
  RecordReader reader(footer.content);
  EXPECT_EQ(reader.number<std::uint64_t>(), kFileOffset);
  EXPECT_EQ(reader.number<std::uint64_t>(),
            kFileOffset + bytes.size() - kMagic.size() - 29 - 6 * (9 + 17));
  const std::size_t checked = bytes.size() - kMagic.size() - sizeof(std::uint32_t);
  EXPECT_EQ(reader.number<std::uint32_t>(), crc32_of(std::span(bytes).first(checked)));
  EXPECT_EQ(Bytes(bytes.end() - 8, bytes.end()), Bytes(kMagic.begin(), kMagic.end()));
}

}  // namespace
}  // namespace echomap::mcap
