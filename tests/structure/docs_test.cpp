// SPDX-License-Identifier: MIT
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/command_blocks.hpp"
#include "tests/structure/desk.hpp"
#include "tests/structure/shell.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"

// A document promises: a ```sh block after the line <!-- test --> runs as it stands, from the root
// of the tree, and every relative link leads to a file.
namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string mark = "<!-- test -->";

std::vector<fs::path> documents() {
  std::vector<fs::path> paths;
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) {
    paths.emplace_back(name);
  }
  for (const auto& entry : fs::recursive_directory_iterator(tree_root / "docs")) {
    if (entry.path().extension() == ".md") {
      paths.push_back(entry.path().lexically_relative(tree_root));
    }
  }
  return paths;
}

TEST(Documents, EveryMarkedCommandRuns) {
  std::size_t blocks = 0;
  for (const fs::path& document : documents()) {
    const Desk desk;
    for (const CommandBlock& block : command_blocks_of(read_lines(tree_root / document))) {
      const ShellResult result = run_shell(block.script, desk.folder());
      EXPECT_EQ(result.exit_code, 0) << document.string() << ":" << block.line << "\n"
                                     << block.script << result.output;
      ++blocks;
    }
  }
  EXPECT_GE(blocks, 1U);
}

TEST(Documents, EveryRelativeLinkLeadsToAFile) {
  static const std::regex link_pattern(R"(\]\(([^)#:]+)(?:#[^)]*)?\))");
  for (const fs::path& document : documents()) {
    for (const std::string& line : read_lines(tree_root / document)) {
      for (std::sregex_iterator link(line.begin(), line.end(), link_pattern), end; link != end;
           ++link) {
        const fs::path target = tree_root / document.parent_path() / (*link)[1].str();
        EXPECT_TRUE(fs::exists(target)) << document.string() << ": " << (*link)[1];
      }
    }
  }
}

TEST(CommandBlocks, AreThoseWithAMark) {
  const auto blocks = command_blocks_of({"text",
                                         "```sh",
                                         "rm -r .",
                                         "```",
                                         mark,
                                         "```sh",
                                         "true",
                                         "echo a",
                                         "```",
                                         mark,
                                         "```sh",
                                         "```"});
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0].line, 5U);
  EXPECT_EQ(blocks[0].script, "true\necho a\n");
  EXPECT_EQ(blocks[1].script, "");
}

TEST(CommandBlocks, RefuseAMarkBeforeAnythingElse) {
  EXPECT_THROW(command_blocks_of({mark, "", "```sh", "true", "```"}), std::runtime_error);
  EXPECT_THROW(command_blocks_of({mark}), std::runtime_error);
}

TEST(CommandBlocks, FailAtTheFirstFailingCommand) {
  const ShellResult result = run_shell("echo before\nfalse\necho after\n", tree_root);
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("before"));
  EXPECT_THAT(result.output, testing::Not(HasSubstr("after")));
}

}  // namespace
}  // namespace echomap::structure
