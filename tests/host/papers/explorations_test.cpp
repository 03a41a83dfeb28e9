// SPDX-License-Identifier: MIT
#include "host/papers/explorations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::papers {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Explorations two_runs(std::vector<std::string> more) {
  Explorations explorations;
  explorations.name = "l_room";
  explorations.arguments = {"--world=l_room", "--emulator=mock", "--no-kidnap", "--stops=2"};
  explorations.arguments.insert(explorations.arguments.end(), more.begin(), more.end());
  explorations.first_seed = 5;
  explorations.runs = 2;
  return explorations;
}

TEST(Explorations, AreInTheOrderOfTheirSeedsAndSayHowManyHaveEnded) {
  const tests::ScratchFolder folder;
  std::vector<std::size_t> ended;
  const auto runs =
      run_explorations(two_runs({}), folder.path(), [&](std::size_t n) { ended.push_back(n); });
  EXPECT_THAT(numbers_of(runs, "/seed"), ElementsAre(5.0, 6.0));
  EXPECT_THAT(ended, ElementsAre(1U, 2U));
  EXPECT_TRUE(exists(runs.front().folder / "map.png"));
}

TEST(Explorations, ThatFailSayWhy) {
  const tests::ScratchFolder folder;
  const std::string error = tests::thrown_text<console::CommandError>(
      [&] { run_explorations(two_runs({"--robot=no_such"}), folder.path(), [](std::size_t) {}); });
  EXPECT_THAT(error, HasSubstr("echomap demo has failed"));
  EXPECT_THAT(error, HasSubstr("no_such"));
  EXPECT_THAT(error, HasSubstr("next: see"));
}

TEST(Explorations, NumbersThatARunDoesNotHaveAreLeftOut) {
  std::vector<ExplorationRun> runs(3);
  runs[0].summary = {{"fitted", {{"wall_rmse_m", 0.25}}}};
  runs[1].summary = {{"fitted", nullptr}};
  runs[2].summary = {{"fitted", {{"wall_rmse_m", 0.5}}}};
  EXPECT_THAT(numbers_of(runs, "/fitted/wall_rmse_m"), ElementsAre(0.25, 0.5));
}

}  // namespace
}  // namespace echomap::papers
