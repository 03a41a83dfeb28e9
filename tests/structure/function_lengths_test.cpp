// SPDX-License-Identifier: MIT
#include "tests/structure/function_lengths.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {
namespace {

using testing::ElementsAre;

std::vector<int> lengths_in(const std::vector<std::string>& lines) {
  std::vector<int> lengths;
  for (const FunctionLength& function : functions_in({"x.cpp", lines})) {
    lengths.push_back(function.lines);
  }
  return lengths;
}

TEST(FunctionLengths, NoFunctionOfTheProductIsLongerThan70Lines) {
  std::vector<std::string> longer;
  for (const SourceFile& file : read_source_tree(ECHOMAP_SOURCE_DIR)) {
    for (const FunctionLength& function : functions_in(file)) {
      if (function.lines > 70 && !is_below(file.path, "tests")) {
        longer.push_back(file.path + ":" + std::to_string(function.line));
      }
    }
  }
  EXPECT_THAT(longer, testing::IsEmpty());
}

TEST(FunctionLengths, RunFromTheFirstLineToTheLastBrace) {
  EXPECT_THAT(lengths_in({"int one() { return 1; }",
                          "",
                          "int two(int a,",
                          "        int b) {",
                          "  if (a) {",
                          "  }",
                          "}"}),
              ElementsAre(1, 5));
}

TEST(FunctionLengths, OfMembersAndTemplatesCount) {
  EXPECT_THAT(lengths_in({"namespace a {",
                          "class B : public C {",
                          " public:",
                          "  int size() const {",
                          "    return 1;",
                          "  }",
                          "};",
                          "template <class T>",
                          "bool operator==(T, T) {",
                          "}",
                          "}"}),
              ElementsAre(3, 3));
}

TEST(FunctionLengths, OfAConstructorHoldItsListOfMembers) {
  EXPECT_THAT(
      lengths_in({"A::A(int b)", "    : b_{b},", "      c_(2),", "      d_{} {", "  run();", "}"}),
      ElementsAre(6));
}

TEST(FunctionLengths, OfValuesDoNotCount) {
  EXPECT_THAT(lengths_in({"const std::array<int, 2> kBoth{{1,",
                          "2}};",
                          "const auto x = f({",
                          "1});",
                          "enum class E { kA };",
                          "struct S { int a{}; int b = g(); };"}),
              testing::IsEmpty());
}

}  // namespace
}  // namespace echomap::structure
