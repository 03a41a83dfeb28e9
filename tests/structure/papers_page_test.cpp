// SPDX-License-Identifier: MIT
#include "tests/structure/papers_page.hpp"

#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/shell.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"

// docs/papers.md promises a command for each feature of the papers: the page is read here, and its
// commands are run, each once, by papers_commands_test.
namespace echomap::structure {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

PapersPage parsed(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return parse_papers_page(lines);
}

const char* const short_page = R"(# The papers
| paper | authors |
|---|---|
| [000](#a) | none |
<!-- test -->
```sh
touch long.toml
```
## 000: a robot
| feature | where | command | see |
|---|---|---|---|
| Wheels | 2.1 | simulated: `echomap demo --out nxt` | `a \| b`. Exit code 8 |
| Sonar | 2.2 | simulated: `echomap demo --out nxt` | echoes |
| Reads | 3 | recording: `echomap export nxt`; two programs: `echomap localize --lockstep gate` | exit code 0 or 7 |
| Both wheels | 4 | not yet | no strategy does |
<!-- test -->
```sh
echomap replay log \
    --out room
echomap-mock --link port --lockstep gate &
timeout 60 sh -c "until [ -e port ]; do sleep 0.1; done"
echomap localize --lockstep gate --out found || [ $? -eq 8 ]
```
## What is left
| Not | a | feature | here |
)";

TEST(PapersPage, HasTheRowsOfThePapersTablesAlone) {
  const PapersPage page = parsed(short_page);
  EXPECT_EQ(page.files, "touch long.toml\n");
  ASSERT_THAT(page.papers, SizeIs(1));
  const PaperSection& paper = page.papers[0];
  EXPECT_EQ(paper.number, "000");
  ASSERT_THAT(paper.features, SizeIs(4));
  EXPECT_EQ(paper.features[0].name, "Wheels");
  EXPECT_EQ(paper.features[0].line, 12U);
  ASSERT_THAT(paper.features[2].commands, SizeIs(2));
  EXPECT_EQ(paper.features[2].commands[0].need, CommandNeed::kRecording);
  EXPECT_EQ(paper.features[2].commands[1].need, CommandNeed::kTwoPrograms);
  EXPECT_EQ(paper.features[2].commands[1].text, "echomap localize --lockstep gate");
  EXPECT_THAT(paper.features[3].commands, IsEmpty());
}

TEST(PapersPage, RunsACommandOnceAndWithTheExitCodesOfAllItsRows) {
  const auto commands = commands_of(parsed(short_page).papers[0]);
  ASSERT_THAT(commands, SizeIs(3));
  EXPECT_EQ(commands[0].command.text, "echomap demo --out nxt");
  EXPECT_THAT(commands[0].exit_codes, ElementsAre(8));
  EXPECT_THAT(commands[1].exit_codes, ElementsAre(0, 7));
}

TEST(PapersPage, FindsWhatItsBlocksMake) {
  const auto preparations = parsed(short_page).papers[0].preparations;
  ASSERT_THAT(preparations, SizeIs(3)) << "the robot, and what writes room and found";
  EXPECT_THAT(preparations[0].made, ElementsAre("room"));
  EXPECT_FALSE(preparations[0].is_robot);
  EXPECT_THAT(preparations[1].made, ElementsAre("port", "gate"));
  EXPECT_TRUE(preparations[1].is_robot);
  EXPECT_THAT(preparations[1].script, HasSubstr("timeout 60"));
}

TEST(PapersPage, MakesFirstWhatACommandReadsAndStartsItsRobot) {
  const PaperSection paper = parsed(short_page).papers[0];
  const auto nothing = [](const std::string&) { return false; };
  const auto all = [](const std::string&) { return true; };
  const PageCommand in_room{1, {CommandNeed::kLog, "echomap localize x --map room"}, {0}};
  EXPECT_THAT(script_for(in_room, paper, nothing), StartsWith("echomap replay log"));
  EXPECT_EQ(script_for(in_room, paper, all), in_room.command.text + "\n");
  PageCommand beside{1, {CommandNeed::kTwoPrograms, "echomap localize --lockstep gate"}, {0}};
  EXPECT_THAT(script_for(beside, paper, nothing),
              AllOf(HasSubstr("echomap-mock --link port"), Not(HasSubstr("--out found"))));
  beside.command.text = "echomap localize --lockstep door";
  EXPECT_THROW(script_for(beside, paper, all), std::runtime_error);
}

TEST(PapersPage, RefusesARowThatItCannotRead) {
  const std::string head =
      "## 000: a robot\n| feature | where | command | see |\n|---|---|---|---|\n";
  EXPECT_THROW(parsed(head + "| Wheels | 2 | `echomap demo` | a |\n"), std::runtime_error);
  EXPECT_THROW(parsed(head + "| Wheels | 2 | by magic: `echomap demo` | a |\n"),
               std::runtime_error);
  EXPECT_THROW(parsed(head + "| Wheels | 2 | soon | a |\n"), std::runtime_error);
  EXPECT_THROW(parsed(head + "| Wheels | 2 | not yet |\n"), std::runtime_error);
}

std::vector<PageCommand> all_commands() {
  std::vector<PageCommand> all;
  for (const PaperSection& paper :
       parse_papers_page(read_lines(tree_root / "docs/papers.md")).papers) {
    for (const PageCommand& command : commands_of(paper)) {
      all.push_back(command);
    }
  }
  return all;
}

/// What `echomap COMMAND --help` prints, by the words of COMMAND.
std::string help_of(const std::string& command) {
  static std::map<std::string, std::string> known;
  std::string& help = known[command];
  if (help.empty()) {
    const ShellResult result =
        run_shell(ECHOMAP_BINARY_DIR "/bin/echomap " + command + " --help", "/");
    EXPECT_EQ(result.exit_code, 0) << command << ": " << result.output;
    help = result.output;
  }
  return help;
}

TEST(PapersPage, NamesOptionsThatItsCommandsHave) {
  for (const PageCommand& command : all_commands()) {
    const auto words = words_of(command.command.text);
    ASSERT_GE(words.size(), 2U) << "docs/papers.md:" << command.line;
    ASSERT_EQ(words[0], "build/release/bin/echomap") << "docs/papers.md:" << command.line;
    const bool is_nested = words[1] == "fleet";
    const std::string help = help_of(words[1] + (is_nested ? " " + words.at(2) : ""));
    for (const std::string& word : words) {
      if (word.rfind("--", 0) == 0) {
        EXPECT_TRUE(std::regex_search(help, std::regex("[ ,]" + word + "[ ,{=]")))
            << "docs/papers.md:" << command.line << ": " << words[1] << " has no " << word;
      }
    }
  }
}

TEST(PapersPage, WritesEachFolderByOneCommand) {
  std::map<std::string, std::string> writers;
  for (const PageCommand& command : all_commands()) {
    const std::string out = value_in(words_of(command.command.text), "--out");
    if (!out.empty()) {
      const auto [writer, is_new] = writers.emplace(out, command.command.text);
      EXPECT_EQ(writer->second, command.command.text) << "docs/papers.md:" << command.line;
    }
  }
}

TEST(PapersPage, HasARobotForEachCommandOfTwoPrograms) {
  const auto page = parse_papers_page(read_lines(tree_root / "docs/papers.md"));
  EXPECT_THAT(page.papers, SizeIs(5));
  for (const PaperSection& paper : page.papers) {
    for (const PageCommand& command : commands_of(paper)) {
      EXPECT_NO_THROW(script_for(command, paper, [](const std::string&) { return true; }));
    }
  }
}

}  // namespace
}  // namespace echomap::structure
