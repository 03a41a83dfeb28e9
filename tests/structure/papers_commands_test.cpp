// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/structure/desk.hpp"
#include "tests/structure/papers_page.hpp"
#include "tests/structure/shell.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"
#include "tests/support/real_data.hpp"

// Every command of docs/papers.md runs, in the order of its rows, a paper's in a folder of their
// own, and ends with 0, or as its row says.
namespace echomap::structure {
namespace {

namespace fs = std::filesystem;

/// Commands that cannot run here, and those that read what these would have written.
class Skipped {
 public:
  /// Why a command cannot run here; empty where it can.
  std::string reason_for(const std::vector<std::string>& words) {
    std::string reason;
    for (const std::string& word : words) {
      const std::string file = word.rfind(kData, 0) == 0 ? word.substr(kData.size()) : "";
      if (!file.empty() && !fs::exists(tests::real_data(file))) {
        reason = tests::real_data(file).string() + " is not here";
      } else if (unwritten_.count(word) > 0) {
        reason = "what writes " + word + " was skipped";
      }
    }
    if (value_in(words, "--board") == "ev3" && !has_ev3()) {
      reason = "the emulated EV3 is not built";
    }
    if (!reason.empty()) {
      unwritten_.insert(value_in(words, "--out"));
      unwritten_.erase("");
    }
    return reason;
  }

 private:
  inline static const std::string kData = "$ECHOMAP_DATA/";

  static bool has_ev3() {
    return fs::exists(ECHOMAP_BINARY_DIR "/bin/echomap-ev3") && has_program("qemu-arm");
  }

  std::set<std::string> unwritten_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(const PageCommand& command, const PaperSection& paper, const Desk& desk) {
  const auto exists = [&](const std::string& name) { return fs::exists(desk.folder() / name); };
  const std::string script = script_for(command, paper, exists);
  const auto start = std::chrono::steady_clock::now();
  const ShellResult result = run_shell(script, desk.folder());
  std::printf("%6.1f s  exit code %d  %s\n",
              seconds_since(start),
              result.exit_code,
              command.command.text.c_str());
  EXPECT_EQ(command.exit_codes.count(result.exit_code), 1U)
      << "docs/papers.md:" << command.line << ": exit code " << result.exit_code << "\n"
      << script << result.output;
}

void run_paper(const std::string& number) {
  ::setenv("ECHOMAP_DATA", fs::absolute(tests::real_data("")).c_str(), 1);
  const PapersPage page = parse_papers_page(read_lines(tree_root / "docs/papers.md"));
  const auto paper = std::find_if(page.papers.begin(),
                                  page.papers.end(),
                                  [&](const PaperSection& each) { return each.number == number; });
  ASSERT_NE(paper, page.papers.end()) << "docs/papers.md has no section " << number;
  const Desk desk;
  const ShellResult files = run_shell(page.files, desk.folder());
  ASSERT_EQ(files.exit_code, 0) << files.output;
  Skipped skipped;
  std::string skips;
  for (const PageCommand& command : commands_of(*paper)) {
    const std::string reason = skipped.reason_for(words_of(command.command.text));
    if (reason.empty()) {
      run(command, *paper, desk);
    } else {
      skips += "\n" + command.command.text + "\n  " + reason;
    }
  }
  if (!skips.empty() && !testing::Test::HasFailure()) {
    GTEST_SKIP() << "all other commands ran; not run:" << skips;
  }
}

TEST(PapersCommands, OfPaper000Run) { run_paper("000"); }
TEST(PapersCommands, OfPaper001Run) { run_paper("001"); }
TEST(PapersCommands, OfPaper002Run) { run_paper("002"); }
TEST(PapersCommands, OfPaper003Run) { run_paper("003"); }
TEST(PapersCommands, OfPaper004Run) { run_paper("004"); }

}  // namespace
}  // namespace echomap::structure
