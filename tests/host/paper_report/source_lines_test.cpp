// SPDX-License-Identifier: MIT
#include "host/paper_report/source_lines.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::paper_report {
namespace {

TEST(SourceLines, FindTheFirstLineWithTheSymbol) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "range.cpp",
                         "// Model.\n\ndouble gaussian_range(double x) {\n  return x;\n}\n"
                         "double gaussian_range(int x);");
  const SourceLines source_lines(folder.path());
  EXPECT_EQ(source_lines.line("range.cpp", "double gaussian_range"), 3);
  EXPECT_EQ(source_lines.line("range.cpp", "(int x)"), 6);
}

TEST(SourceLines, AreEmptyWhereThereIsNoSuchLine) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "range.cpp", "double range;\n");
  const SourceLines source_lines(folder.path());
  EXPECT_FALSE(source_lines.line("range.cpp", "double bearing").has_value());
  EXPECT_FALSE(source_lines.line("range.cpp", "").has_value());
  EXPECT_FALSE(source_lines.line("bearing.cpp", "double range").has_value());
  EXPECT_FALSE(SourceLines(folder / "none").line("range.cpp", "double range").has_value());
}

TEST(SourceLines, AreThoseOfTheTree) {
  const SourceLines source_lines(ECHOMAP_SOURCE_DIR);
  EXPECT_EQ(source_lines.line("host/paper_report/source_lines.hpp", "#pragma once"), 2);
}

TEST(SourceLines, LinkOnlyWithABase) {
  EXPECT_FALSE(SourceLines("/x").link("host/a.cpp").has_value());
  EXPECT_EQ(SourceLines("/x", "file:///x/").link("host/a.cpp"), "file:///x/host/a.cpp");
  EXPECT_EQ(SourceLines("/x", "..").link("host/a.cpp"), "../host/a.cpp");
}

}  // namespace
}  // namespace echomap::paper_report
