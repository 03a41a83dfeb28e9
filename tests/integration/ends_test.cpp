// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/staged_ends.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Ends : public ::testing::TestWithParam<StagedEnd> {
 protected:
  const tests::ScratchFolder scratch_;
};

TEST_P(Ends, SayHowItWentAndWhatToDoNext) {
  const StagedRun run = drive(GetParam(), scratch_.path());
  EXPECT_THAT(differences(GetParam(), run), IsEmpty()) << run.ended.said;
}

std::string name_of_end(const ::testing::TestParamInfo<StagedEnd>& end) { return end.param.name; }

INSTANTIATE_TEST_SUITE_P(Staged, Ends, ::testing::ValuesIn(staged_ends()), name_of_end);

/// It ends as where the sonar dies on the way, but before there is a map.
StagedEnd sonar_dead_from_the_start() {
  StagedEnd end =
      *std::find_if(staged_ends().begin(), staged_ends().end(), [](const StagedEnd& staged) {
        return std::string_view(staged.name) == "SonarDead";
      });
  end.name = "SonarDeadFromTheStart";
  end.stage = demo_stage({"--part-faults=sonar-dead@0"});
  return end;
}

INSTANTIATE_TEST_SUITE_P(Others, Ends, ::testing::Values(sonar_dead_from_the_start()), name_of_end);

TEST(StagedEnds, AreTwelve) { EXPECT_EQ(staged_ends().size(), 12U); }

/// What was saved at the first stop does not say that it is the whole run.
TEST(StagedEnds, OfADiskThatBecomesFullAreNoWholeRun) {
  const tests::ScratchFolder scratch;
  StagedEnd end;
  end.stage = full_disk_stage(4, 200);
  const StagedRun run = drive(end, scratch.path());
  EXPECT_EQ(run.ended.status, 1);
  EXPECT_THAT(run.closing_paragraph,
              HasSubstr("the run is not saved, or only up to an earlier stop"));
  ASSERT_TRUE(run.summary);
  EXPECT_EQ(run.summary->at("outcome"), "exploring");
  EXPECT_EQ(run.summary->at("finished"), false);
  EXPECT_LT(run.summary->at("stops"), 4);
}

StagedRun a_run_as_golden(const StagedEnd& golden, const std::string& next) {
  StagedRun run;
  run.ended = {golden.status, "echomap: error: why\n  next: " + next + "\n"};
  run.closing_paragraph = golden.closing_paragraph;
  run.summary = {
      {"outcome", golden.outcome}, {"finished", false}, {"why", "why"}, {"next", "step"}};
  return run;
}

TEST(StagedEnds, DifferWhereCodeOrTextOrSummaryIsAnother) {
  StagedEnd golden;
  golden.status = 7;
  golden.outcome = "lost";
  golden.closing_paragraph = "why, and a step";
  EXPECT_THAT(differences(golden, a_run_as_golden(golden, "step")), IsEmpty());
  EXPECT_THAT(differences(golden, a_run_as_golden(golden, "else")), ElementsAre(HasSubstr("step")));
  StagedRun other = a_run_as_golden(golden, "step");
  other.ended.status = -1;
  other.closing_paragraph = "nothing";
  other.summary.reset();
  EXPECT_THAT(
      differences(golden, other),
      ElementsAre("exit code -1 in place of 7", "says: nothing", "there is no summary.json"));
}

TEST(StagedEnds, DifferWhereSomethingIsSavedThatShouldNotBe) {
  StagedEnd golden;
  StagedRun run;
  run.ended.status = 0;
  EXPECT_THAT(differences(golden, run), IsEmpty());
  run.saved = {"session.mcap", "points.csv"};
  EXPECT_THAT(differences(golden, run), IsEmpty()) << "nobody takes that for a run";
  run.saved.insert("summary.json");
  EXPECT_THAT(differences(golden, run), ElementsAre(HasSubstr("calls what is cut off a run")));
}

TEST(StagedEnds, DifferWhereTheMapSoFarIsNotSaved) {
  StagedEnd golden;
  golden.status = 1;
  golden.outcome = "lost";
  golden.mapped_m2 = 0.5;
  StagedRun run = a_run_as_golden(golden, "step");
  EXPECT_THAT(differences(golden, run), ElementsAre("the map so far is not saved"));
  (*run.summary)["free_area_m2"] = 0.6;
  run.saved = {"map.png", "summary.json"};
  EXPECT_THAT(differences(golden, run), IsEmpty());
}

}  // namespace
}  // namespace echomap::test
