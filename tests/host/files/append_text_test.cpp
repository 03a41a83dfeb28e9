// SPDX-License-Identifier: MIT
#include "host/files/append_text.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::files {
namespace {

TEST(AppendText, AddsToTheEndOfAFile) {
  const tests::ScratchFolder folder;
  write_text_file(folder / "file", "one\n");
  append_text(folder / "file", "two\n");
  append_text(folder / "file", "");
  append_text(folder / "file", "three\n");
  EXPECT_EQ(read_text_file(folder / "file"), "one\ntwo\nthree\n");
}

TEST(AppendText, MakesNoFile) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(append_text(folder / "file", "one\n"), FileError);
  EXPECT_FALSE(exists(folder / "file"));
}

TEST(AppendText, SaysThatADiskIsFull) {
  EXPECT_THROW(append_text("/dev/full", "one\n"), FileError);
}

}  // namespace
}  // namespace echomap::files
