// SPDX-License-Identifier: MIT
#include "tests/structure/type_definitions.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> names_in(const std::vector<std::string>& lines) {
  std::vector<std::string> names;
  for (const TypeDefinition& type : type_definitions_in({"x.hpp", lines})) {
    names.push_back(type.name + ":" + std::to_string(type.line));
  }
  return names;
}

TEST(TypeDefinitions, NoTypeOfTheProductIsDefinedTwice) {
  std::vector<SourceFile> product = read_source_tree(ECHOMAP_SOURCE_DIR);
  std::erase_if(product, [](const SourceFile& file) { return is_below(file.path, "tests"); });
  EXPECT_THAT(types_defined_twice(product), IsEmpty());
}

TEST(TypeDefinitions, OfTheTreeAreFound) {
  std::size_t count = 0;
  for (const SourceFile& file : read_source_tree(ECHOMAP_SOURCE_DIR)) {
    count += type_definitions_in(file).size();
  }
  EXPECT_GT(count, 500U);
}

TEST(TypeDefinitions, HaveTheirNamespaces) {
  EXPECT_THAT(names_in({"namespace echomap {",
                        "namespace mapping {",
                        "struct Cell {};",
                        "}",
                        "enum class Mode : int { kOn };",
                        "}",
                        "class Outer final : public Base<int> {",
                        "};"}),
              ElementsAre("echomap::mapping::Cell:3", "echomap::Mode:5", "Outer:7"));
}

TEST(TypeDefinitions, OfTemplatesCountAndTheirSpecialisationsDoNot) {
  EXPECT_THAT(names_in({"template <class T, class U = std::vector<T>>",
                        "struct [[nodiscard]] Pair {};",
                        "template <>",
                        "struct Pair<int, int> {};"}),
              ElementsAre("Pair:2"));
}

TEST(TypeDefinitions, InFunctionsTypesAndAnonymousNamespacesDoNotCount) {
  EXPECT_THAT(names_in({"namespace {",
                        "struct Hidden {};",
                        "}",
                        "void f() { struct Local {}; }",
                        "class Later;",
                        "struct Outer { struct Inner {}; };",
                        "const Outer outer{};"}),
              ElementsAre("Outer:6"));
}

TEST(TypeDefinitions, InCommentsLiteralsAndMacrosDoNotCount) {
  EXPECT_THAT(names_in({"// struct A {};",
                        "/* { */ const char* text = \"struct B { \\\" {\";",
                        "const char brace = '{'; const int many = 1'000;",
                        "const char* raw = R\"x({ \" )x\";",
                        "#define C struct C { \\",
                        "  {",
                        "struct D {};"}),
              ElementsAre("D:7"));
}

TEST(TypeDefinitions, CatchASecondOneInAnotherFile) {
  const std::vector<std::string> lines{"namespace a {", "struct Params {};", "}"};
  EXPECT_THAT(types_defined_twice({{"host/x.hpp", lines},
                                   {"host/y.hpp", lines},
                                   {"host/z.hpp", {"namespace b {", "struct Params {};", "}"}}}),
              ElementsAre("a::Params: host/x.hpp:2, host/y.hpp:2"));
}

}  // namespace
}  // namespace echomap::structure
