// SPDX-License-Identifier: MIT
#include "host/datasets/companion_file.hpp"

#include <gmock/gmock.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

TEST(CompanionFile, StandsBesideTheLogPackedOrNot) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "a_ODO.txt", "1\n");
  tests::write_gz(folder / "a_REF.txt.gz", "2\n");
  for (const char* log : {"a_LASER.txt", "a_LASER.txt.gz"}) {
    EXPECT_EQ(companion_file(folder / log, "_LASER.txt", "_ODO.txt"), folder / "a_ODO.txt");
    EXPECT_EQ(companion_file(folder / log, "_LASER.txt", "_REF.txt"), folder / "a_REF.txt.gz");
    EXPECT_EQ(companion_file(folder / log, "_LASER.txt", "_TIME.txt"), std::nullopt);
  }
  EXPECT_THAT(tests::thrown_text<files::FileError>(
                  [&] { required_companion(folder / "a_LASER.txt", "_LASER.txt", "_TIME.txt"); }),
              HasSubstr("a_TIME.txt"));
  EXPECT_THAT(tests::thrown_text<files::FileError>(
                  [&] { companion_file(folder / "b.txt", "_LASER.txt", "_ODO.txt"); }),
              HasSubstr("ends in _LASER.txt"));
}

TEST(CompanionLines, SkipCommentsAndEndWhereTheFileEnds) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "log", "first\n");
  files::write_text_file(folder / "beside", "# a comment\n\n1\n");
  LineReader log(folder / "log");
  log.next();
  CompanionLines lines(folder / "beside");
  EXPECT_EQ(lines.require(log).integer("n"), 1);
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { lines.require(log); }),
              HasSubstr("log:1: no line of"));
}

}  // namespace
}  // namespace echomap::datasets
