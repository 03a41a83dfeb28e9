// SPDX-License-Identifier: MIT
#include "host/exports/pgm_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

class PgmImageTest : public ::testing::Test {
 protected:
  std::string complaint(const std::string& bytes) {
    files::write_text_file(folder / "a.pgm", bytes);
    return tests::thrown_text<files::FileError>([&] { read_pgm(folder / "a.pgm"); });
  }

  tests::ScratchFolder folder;
};

TEST_F(PgmImageTest, ReadsBackEveryByteThereIs) {
  PgmImage image{16, 16, {}};
  for (int i = 0; i < 256; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(i));
  }
  write_pgm(folder / "a.pgm", image);
  const PgmImage read = read_pgm(folder / "a.pgm");
  EXPECT_EQ(read.columns, 16);
  EXPECT_EQ(read.rows, 16);
  EXPECT_EQ(read.pixels, image.pixels);
}

TEST_F(PgmImageTest, ReadsTheCommentOfMapSaver) {
  files::write_text_file(folder / "a.pgm", "P5\n# CREATOR: map_saver\n2 1\n255\nab");
  EXPECT_EQ(read_pgm(folder / "a.pgm").pixels, (std::vector<std::uint8_t>{'a', 'b'}));
}

TEST_F(PgmImageTest, RefusesWhatIsNone) {
  EXPECT_THAT(complaint("P2\n2 1\n255\n0 0\n"), HasSubstr("a.pgm:1: expected a binary PGM"));
  EXPECT_THAT(complaint("P5\n0 1\n255\n"), HasSubstr("expected a binary PGM"));
  EXPECT_THAT(complaint("P5\n2 1\n65535\nabcd"), HasSubstr("expected a binary PGM"));
  EXPECT_THAT(complaint("P5\n999999999 999999999\n255\n"), HasSubstr("expected a binary PGM"));
  EXPECT_THAT(complaint(""), HasSubstr("expected a binary PGM"));
}

TEST_F(PgmImageTest, CountsThePixelsThatAreMissing) {
  EXPECT_THAT(complaint("P5\n2 2\n255\nabc"), HasSubstr("a.pgm: expected 4 pixels, found 3"));
}

}  // namespace
}  // namespace echomap::exports
