// SPDX-License-Identifier: MIT
#include "tests/benchmarks/told_ends.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// One that is told, one that is told wrongly and one that was not run.
std::vector<ToldEnd> three_ends() {
  return {{"Finished", "", 0, "complete", {}},
          {"Lost", "", 1, "lost", {"says: nothing"}},
          {"Cable", "no emulator", -1, "", {}}};
}

TEST(ToldEnds, CountThoseThatAreAsTheirGoldenTexts) {
  const auto figures = told_figures(three_ends());
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "ends_told_of_12");
  EXPECT_EQ(figures[0].value, 1.0) << "an end that is not run is not told";
  EXPECT_EQ(figures[0].runs, 3U);
}

TEST(ToldEnds, HaveARowForEachEnd) {
  const MarkdownTable table = told_table(three_ends());
  EXPECT_THAT(table.rows,
              ElementsAre(ElementsAre("Finished", "0", "complete", "yes"),
                          ElementsAre("Lost", "1", "lost", "no"),
                          ElementsAre("Cable", "-", "-", "not run: no emulator")));
  EXPECT_EQ(table.rows[0].size(), table.header.size());
}

/// An end without a program: what the user would have seen and found.
test::StagedEnd an_end(test::Stage stage) {
  test::StagedEnd end;
  end.name = "Lost";
  end.stage = std::move(stage);
  end.status = 1;
  end.outcome = "lost";
  end.closing_paragraph = "echomap: error: lost\n  next: start again\n";
  return end;
}

TEST(ToldEnds, AreToldWhereExitCodeTextAndSummaryAreGolden) {
  const tests::ScratchFolder scratch;
  const auto stage = [](const std::string& outcome) {
    return [=](const test::StageFolder& folder) {
      create_directories(folder.run);
      files::write_text_file(folder.run / "summary.json",
                             R"({"finished": false, "why": "lost", "next": "start again",
                                 "outcome": ")" +
                                 outcome + "\"}");
      return test::Ended{1, "a line\nechomap: error: lost\n  next: start again\n"};
    };
  };
  const ToldEnd told = tell_end(an_end(stage("lost")), scratch / "told");
  EXPECT_TRUE(told.is_told()) << ::testing::PrintToString(told.differences);
  EXPECT_EQ(told.outcome, "lost");
  const ToldEnd other = tell_end(an_end(stage("complete")), scratch / "other");
  EXPECT_TRUE(other.has_run());
  EXPECT_FALSE(other.is_told());
}

TEST(ToldEnds, NameAnEndThatDoesNotComeAbout) {
  const tests::ScratchFolder scratch;
  const ToldEnd told = tell_end(an_end([](const test::StageFolder&) -> test::Ended {
                                  throw std::runtime_error("no emulator");
                                }),
                                scratch / "none");
  EXPECT_EQ(told.why_not_run, "no emulator");
  EXPECT_FALSE(told.is_told());
  EXPECT_THAT(told.differences, IsEmpty());
}

}  // namespace
}  // namespace echomap::bench
