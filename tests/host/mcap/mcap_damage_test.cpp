// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mcap/record_encoding.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/scratch_folder.hpp"

// Every file that one cut or one wrong bit makes of a small one.
namespace echomap::mcap {
namespace {

using testing::ElementsAreArray;

bool is_prefix_of(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
  return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

class McapDamageTest : public testing::TestWithParam<Compression> {
 protected:
  void SetUp() override {
    const tests::ScratchFolder folder;
    write_small_file(folder / "run.mcap", GetParam());
    whole_ = load_bytes(folder / "run.mcap");
    whole_out_ = read(whole_);
    ASSERT_EQ(whole_out_.error, "");
  }
  ReadOut read(const Bytes& bytes) {
    file_.write(bytes);
    return read_out(file_.path());
  }
  /// Where the last record of the data section ends.
  std::size_t data_end() const {
    Bytes end;
    append_data_end(end, 0);
    end.resize(kRecordHeadBytes);
    const auto at = std::find_end(whole_.begin(), whole_.end(), end.begin(), end.end());
    return static_cast<std::size_t>(at - whole_.begin()) + kRecordHeadBytes + sizeof(std::uint32_t);
  }

  Bytes whole_;
  ReadOut whole_out_;

 private:
  fuzz::MemoryFile file_;
};

TEST_P(McapDamageTest, EveryCutLeavesAPrefix) {
  const std::size_t data_bytes = data_end();
  std::size_t records = 0;
  for (std::size_t length = kMagic.size(); length <= whole_.size(); ++length) {
    const ReadOut out = read(Bytes(whole_.begin(), whole_.begin() + static_cast<int>(length)));
    ASSERT_TRUE(is_prefix_of(out.lines, whole_out_.lines)) << length;
    ASSERT_GE(out.lines.size(), records) << length;
    ASSERT_EQ(out.is_cut_off, length < data_bytes) << length << ": " << out.error;
    ASSERT_EQ(out.error.empty(), length >= data_bytes) << length << ": " << out.error;
    records = out.lines.size();
  }
  EXPECT_EQ(records, whole_out_.lines.size());
}

TEST_P(McapDamageTest, EveryWrongBitLeavesAPrefixOfTheMessages) {
  for (std::size_t bit = 0; bit < 8 * whole_.size(); ++bit) {
    Bytes bytes = whole_;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const ReadOut out = read(bytes);
    ASSERT_TRUE(is_prefix_of(out.messages, whole_out_.messages)) << "byte " << bit / 8;
    if (out.error.empty()) {
      ASSERT_THAT(out.lines, ElementsAreArray(whole_out_.lines)) << "byte " << bit / 8;
      // What is behind the data is not read, and the last record may be longer than it has to be.
      ASSERT_GT(bit / 8, data_end() - sizeof(std::uint32_t) - kRecordHeadBytes);
      ASSERT_TRUE(bit / 8 < data_end() - sizeof(std::uint32_t) || bit / 8 >= data_end());
    }
  }
}

TEST_P(McapDamageTest, AFinishedFileIsDamagedRatherThanCutOff) {
  for (std::size_t bit = 0; bit < 8 * data_end(); ++bit) {
    Bytes bytes = whole_;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    ASSERT_FALSE(read(bytes).is_cut_off) << "byte " << bit / 8;
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions,
                         McapDamageTest,
                         testing::Values(Compression::kNone, Compression::kZstd, Compression::kLz4),
                         [](const auto& param) {
                           const std::string name = name_of(param.param);
                           return name.empty() ? "none" : name;
                         });

}  // namespace
}  // namespace echomap::mcap
