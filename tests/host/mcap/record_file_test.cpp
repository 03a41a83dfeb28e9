// SPDX-License-Identifier: MIT
#include "host/mcap/record_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/crc32.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class RecordFileTest : public testing::Test {
 protected:
  RecordFileTest() {
    append_metadata(bytes_, {"first", {}});
    second_offset_ = bytes_.size();
    append_data_end(bytes_, 7);
  }
  std::filesystem::path saved(const Bytes& bytes) const {
    save_bytes(folder_ / "file", bytes);
    return folder_ / "file";
  }

  Bytes bytes_{kMagic.begin(), kMagic.end()};
  std::size_t second_offset_ = 0;

 private:
  tests::ScratchFolder folder_;
};

TEST_F(RecordFileTest, ReadsHeadsAndContents) {
  RecordFile file(saved(bytes_));
  const auto first = file.next_head();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->opcode, Opcode::kMetadata);
  EXPECT_EQ(first->offset, kMagic.size());
  file.skip_content(*first);
  const auto second = file.next_head();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->offset, second_offset_);
  EXPECT_EQ(file.crc_before_record(), crc32_of(std::span(bytes_).first(second_offset_)));
  Bytes content;
  file.read_content(*second, content);
  EXPECT_EQ(content, (Bytes{7, 0, 0, 0}));
  EXPECT_FALSE(file.next_head());
  EXPECT_EQ(file.progress(), 1.0);
}

TEST_F(RecordFileTest, IsCutOffInTheMidstOfARecord) {
  for (const std::size_t missing : {1U, 5U}) {
    RecordFile file(saved({bytes_.begin(), bytes_.end() - static_cast<int>(missing)}));
    const auto first = file.next_head();
    ASSERT_TRUE(first);
    file.skip_content(*first);
    EXPECT_THAT(tests::thrown_text<CutOffFile>([&] { file.next_head(); }),
                HasSubstr("file: byte " + std::to_string(second_offset_) + ": "));
  }
}

TEST_F(RecordFileTest, IsDamagedWhereItHasItsEndAllTheSame) {
  overwrite_number(bytes_, second_offset_ + 1, std::uint64_t{1000});
  bytes_.insert(bytes_.end(), kMagic.begin(), kMagic.end());
  RecordFile file(saved(bytes_));
  const auto first = file.next_head();
  ASSERT_TRUE(first);
  file.skip_content(*first);
  EXPECT_EQ(
      tests::thrown_text<CutOffFile>([&] { EXPECT_THROW(file.next_head(), files::FileError); }),
      "");
}

TEST_F(RecordFileTest, IsNoMcapFileWithoutItsMagic) {
  bytes_[5] = '1';
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { RecordFile file(saved(bytes_)); }),
              EndsWith("file: not an MCAP file"));
}

}  // namespace
}  // namespace echomap::mcap
