// SPDX-License-Identifier: MIT
#include "host/mcap/output_file.hpp"

#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/crc32.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

using testing::HasSubstr;

TEST(OutputFile, CollectsUntilItIsOpened) {
  const tests::ScratchFolder folder;
  OutputFile file;
  file.pending() = bytes_of("begin");
  file.write_out();
  EXPECT_EQ(file.written_bytes(), 0U);
  EXPECT_EQ(file.size_bytes(), 5U);
  file.open(folder / "file");
  file.write_out();
  EXPECT_EQ(file.written_bytes(), 5U);
  EXPECT_EQ(load_bytes(folder / "file"), bytes_of("begin"));
}

TEST(OutputFile, GrowsAtItsEnd) {
  const tests::ScratchFolder folder;
  OutputFile file;
  file.open(folder / "file");
  for (const char* text : {"one ", "two ", "three"}) {
    file.pending() = bytes_of(text);
    file.write_out();
  }
  EXPECT_EQ(load_bytes(folder / "file"), bytes_of("one two three"));
}

TEST(OutputFile, CountsWhatIsPendingForTheChecksum) {
  const tests::ScratchFolder folder;
  OutputFile file;
  file.open(folder / "file");
  file.pending() = bytes_of("12345");
  file.write_out();
  file.pending() = bytes_of("6789");
  EXPECT_EQ(file.crc(), crc32_of(bytes_of("123456789")));
}

TEST(OutputFile, KeepsWhatCouldNotBeWritten) {
  OutputFile file;
  file.open("/dev/full");
  file.pending() = bytes_of("bytes");
  for (int attempt = 0; attempt < 2; ++attempt) {
    EXPECT_THAT(tests::thrown_text<files::FileError>([&] { file.write_out(); }),
                HasSubstr("cannot write /dev/full: No space left on device"));
  }
  EXPECT_EQ(file.written_bytes(), 0U);
  EXPECT_EQ(file.pending(), bytes_of("bytes"));
}

TEST(OutputFile, IsOpenedOnce) {
  const tests::ScratchFolder folder;
  OutputFile file;
  EXPECT_THROW(file.open(folder / "none/file"), files::FileError);
  file.open(folder / "file");
  EXPECT_THROW(file.open(folder / "other"), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

}  // namespace
}  // namespace echomap::mcap
