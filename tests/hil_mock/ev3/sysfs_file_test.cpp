// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/sysfs_file.hpp"

#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::ev3 {
namespace {

class SysfsFileTest : public testing::Test {
 protected:
  /// As a program writes that has the file open: what stood behind stays.
  void write_over(const std::string& text) {
    std::fstream file(scratch / "position", std::ios::in | std::ios::out);
    file << text;
  }

  tests::ScratchFolder scratch;
  SysfsFile file{scratch / "position", "1234"};
};

TEST_F(SysfsFileTest, HoldsOneLine) {
  EXPECT_EQ(files::read_text_file(scratch / "position"), "1234\n");
  file.show(-7);
  EXPECT_EQ(files::read_text_file(scratch / "position"), "-7\n");
  EXPECT_EQ(file.number(), -7);
}

TEST_F(SysfsFileTest, ReadsWhatWasWrittenOverALongerLine) {
  write_over("5\n");
  EXPECT_EQ(file.text(), "5");
  EXPECT_EQ(file.number(), 5);
}

TEST_F(SysfsFileTest, KnowsWhetherSomebodyElseHasWritten) {
  EXPECT_FALSE(file.has_changed());
  write_over("0\n");
  EXPECT_TRUE(file.has_changed());
  file.show("1234");
  EXPECT_FALSE(file.has_changed()) << "shown again over what the other wrote";
}

TEST_F(SysfsFileTest, NamesTheFileWhereNoNumberStands) {
  file.show("fast");
  EXPECT_THAT(tests::thrown_text<std::runtime_error>([&] { file.number(); }),
              testing::HasSubstr("position: 'fast' is no number"));
}

}  // namespace
}  // namespace echomap::ev3
