// SPDX-License-Identifier: MIT
#include "host/files/atomic_file.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::files {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public ::testing::Test {
 protected:
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
  }

  tests::ScratchFolder folder;
};

TEST_F(AtomicFileTest, AppearsOnlyWhenCommitted) {
  AtomicFile file(folder / "map.txt");
  file.write("half");
  EXPECT_FALSE(fs::exists(folder / "map.txt"));
  file.commit();
  EXPECT_EQ(read_text_file(folder / "map.txt"), "half");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(AtomicFileTest, LeavesTheOlderFileWhenAbandoned) {
  write_text_file(folder / "map.txt", "old");
  { AtomicFile(folder / "map.txt").write("new, never finished"); }
  EXPECT_EQ(read_text_file(folder / "map.txt"), "old");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(AtomicFileTest, NamesPathAndReasonWhenTheFolderIsMissing) {
  try {
    AtomicFile file(folder / "none/map.txt");
    FAIL() << "a file in a missing folder was created";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("none/map.txt"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No such file or directory"));
  }
}

TEST_F(AtomicFileTest, ReportsAFullDisk) {
  // /dev/full answers every write with ENOSPC; the temporary name is a link to it.
  fs::create_symlink("/dev/full", folder / "map.txt.part");
  AtomicFile file(folder / "map.txt");
  try {
    file.write("bytes");
    FAIL() << "a write to a full disk passed";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No space left on device"));
  }
}

TEST_F(AtomicFileTest, ReadingAMissingFileNamesIt) {
  EXPECT_THROW(read_text_file(folder / "none.txt"), FileError);
  EXPECT_THROW(read_text_file(folder.path()), FileError);
}

}  // namespace
}  // namespace echomap::files
