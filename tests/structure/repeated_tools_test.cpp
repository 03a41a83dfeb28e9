// SPDX-License-Identifier: MIT
#include "tests/structure/repeated_tools.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The mock's physics are its own on purpose, and tests may draw as they like.
std::vector<SourceFile> host() {
  std::vector<SourceFile> files = read_source_tree(ECHOMAP_SOURCE_DIR);
  std::erase_if(files, [](const SourceFile& file) { return !is_below(file.path, "host"); });
  return files;
}

std::vector<std::string> signatures_in(const std::vector<std::string>& lines) {
  std::vector<std::string> signatures;
  for (const Tool& tool : tools_in({"x.cpp", lines})) {
    signatures.push_back(tool.signature);
  }
  return signatures;
}

TEST(RepeatedTools, TheHostHasOneOfEach) { EXPECT_THAT(repeated_tools(host()), IsEmpty()); }

TEST(RepeatedTools, TheHostHasOneSolverOfLeastSquares) {
  EXPECT_THAT(second_solvers(host(), "host/optimization"), IsEmpty());
}

TEST(RepeatedTools, AreFoundInTheHost) {
  std::size_t count = 0;
  for (const SourceFile& file : host()) {
    count += tools_in(file).size();
  }
  EXPECT_GT(count, 50U);
}

TEST(RepeatedTools, AreFunctionsThatKnowNothingOfTheProject) {
  EXPECT_THAT(
      signatures_in({"double square(double value) { return value * value; }",
                     "Eigen::Vector2d turned(const Eigen::Vector2d& by,",
                     "                       std::map<int, double> many = {}) {",
                     "  return {};",
                     "}",
                     "double length(const Segment& segment) {",
                     "double area(const std::vector<Segment>& sides) {",
                     "  double inner(double x) {",
                     "double declared(double x);",
                     "double nothing() {"}),
      ElementsAre("square(double)", "turned(const Eigen::Vector2d&, std::map<int, double>)"));
}

TEST(RepeatedTools, CatchASecondOneInAnotherFile) {
  const SourceFile first{"host/a/x.cpp", {"double square(double value) {"}};
  const SourceFile second{"host/b/y.cpp", {"double square(double x) { return x * x; }"}};
  const SourceFile other{"host/b/z.cpp", {"int square(int x) {"}};
  EXPECT_THAT(repeated_tools({first, second, other}),
              ElementsAre("square(double): host/a/x.cpp, host/b/y.cpp"));
}

TEST(RepeatedTools, CatchASolverOutsideOfItsFolder) {
  const std::vector<std::string> lines{"x", "step = -information.ldlt().solve(gradient);"};
  EXPECT_THAT(second_solvers({{"host/optimization/a.cpp", lines}, {"host/slam/b.cpp", lines}},
                             "host/optimization"),
              ElementsAre("host/slam/b.cpp:2"));
}

}  // namespace
}  // namespace echomap::structure
