// SPDX-License-Identifier: MIT
#include "host/files/atomic_file.hpp"

#include <filesystem>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::files {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public ::testing::Test {
 protected:
  AtomicFileTest()
      : folder_(fs::path(::testing::TempDir()) / ("atomic" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~AtomicFileTest() override { fs::remove_all(folder_); }

  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, AppearsOnlyWhenCommitted) {
  AtomicFile file(folder_ / "map.txt");
  file.write("half");
  EXPECT_FALSE(fs::exists(folder_ / "map.txt"));
  file.commit();
  EXPECT_EQ(read_text_file(folder_ / "map.txt"), "half");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(AtomicFileTest, LeavesTheOlderFileWhenAbandoned) {
  write_text_file(folder_ / "map.txt", "old");
  { AtomicFile(folder_ / "map.txt").write("new, never finished"); }
  EXPECT_EQ(read_text_file(folder_ / "map.txt"), "old");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(AtomicFileTest, NamesPathAndReasonWhenTheFolderIsMissing) {
  try {
    AtomicFile file(folder_ / "none" / "map.txt");
    FAIL() << "a file in a missing folder was created";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("none/map.txt"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No such file or directory"));
  }
}

TEST_F(AtomicFileTest, ReportsAFullDisk) {
  // /dev/full answers every write with ENOSPC; the temporary name is a link to it.
  fs::create_symlink("/dev/full", folder_ / "map.txt.part");
  AtomicFile file(folder_ / "map.txt");
  try {
    file.write("bytes");
    FAIL() << "a write to a full disk passed";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No space left on device"));
  }
}

TEST_F(AtomicFileTest, ReadingAMissingFileNamesIt) {
  EXPECT_THROW(read_text_file(folder_ / "none.txt"), FileError);
  EXPECT_THROW(read_text_file(folder_), FileError);
}

}  // namespace
}  // namespace echomap::files
