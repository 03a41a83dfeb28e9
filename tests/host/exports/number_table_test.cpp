// SPDX-License-Identifier: MIT
#include "host/exports/number_table.hpp"

#include <array>
#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr NumberTableFormat kFormat{"a,b", ',', 2};

class NumberTableTest : public ::testing::Test {
 protected:
  std::vector<NumberRow> read(const std::string& text) {
    files::write_text_file(folder / "table.csv", text);
    return read_number_table(folder / "table.csv", kFormat);
  }
  std::string complaint(const std::string& text) {
    return tests::thrown_text<files::FileError>([&] { read(text); });
  }

  tests::ScratchFolder folder;
};

TEST_F(NumberTableTest, KeepsEveryBitOfANumber) {
  std::mt19937_64 random(7);
  std::string text = "a,b\n";
  std::vector<std::array<double, 2>> rows;
  while (rows.size() < 500) {
    std::array<double, 2> row{};
    for (double& value : row) {
      const std::uint64_t bits = random() & 0xBFFFFFFFFFFFFFFFULL;  // keeps it finite
      std::memcpy(&value, &bits, sizeof value);
    }
    rows.push_back(row);
    append_row(text, row, ',');
  }
  const auto read_rows = read(text);
  ASSERT_EQ(read_rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(std::memcmp(rows[i].data(), read_rows[i].values.data(), sizeof rows[i]), 0);
  }
}

TEST_F(NumberTableTest, WritesNumbersAsShortAsTheyAre) {
  std::string text;
  append_row(text, std::array{0.1, -2.0, 1e-7}, ' ');
  EXPECT_EQ(text, "0.1 -2 1e-07\n");
}

TEST_F(NumberTableTest, SkipsComments) {
  EXPECT_EQ(read("# made today\na,b\n1,2\n# half\n3,4\n").size(), 2U);
}

TEST_F(NumberTableTest, NamesFileAndLineOfAWrongNumber) {
  EXPECT_THAT(complaint("a,b\n1,2\n3,x\n"), EndsWith("table.csv:3: 'x' is not a finite number"));
  EXPECT_THAT(complaint("a,b\n1,nan\n"), HasSubstr("table.csv:2: 'nan'"));
  EXPECT_THAT(complaint("a,b\n1, 2\n"), HasSubstr("table.csv:2: ' 2'"));
}

TEST_F(NumberTableTest, NamesFileAndLineOfAWrongRow) {
  EXPECT_THAT(complaint("a,b\n1,2\n\n"), HasSubstr("table.csv:3: expected 2 columns, found 1"));
  EXPECT_THAT(complaint("a,b\n1,2,3\n"), HasSubstr("expected 2 columns, found 3"));
}

TEST_F(NumberTableTest, AsksForItsHeader) {
  EXPECT_THAT(complaint("b,a\n"), HasSubstr("table.csv:1: expected the header 'a,b'"));
  EXPECT_THAT(complaint(""), HasSubstr("table.csv:1: expected the header 'a,b'"));
}

TEST_F(NumberTableTest, SaysWhichFileIsMissing) {
  const auto text = tests::thrown_text<files::FileError>(
      [&] { read_number_table(folder / "none.csv", kFormat); });
  EXPECT_THAT(text, HasSubstr("none.csv"));
}

}  // namespace
}  // namespace echomap::exports
