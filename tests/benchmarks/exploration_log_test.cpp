// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_log.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

const ExplorationCase in_the_hall{"hall", "frontier", "uno_2wd"};

ExplorationRun some_run() {
  ExplorationRun run;
  run.complete = true;
  run.outcome = "complete";
  run.free_iou = 0.1 + 0.2;
  run.sim_seconds = 61.25;
  run.hard_collisions = 2;
  run.phases = 7;
  return run;
}

TEST(ExplorationLog, GivesBackWhatAnEarlierOneWasGiven) {
  const tests::ScratchFolder folder;
  ExplorationLog(folder / "runs").add(in_the_hall, 3, some_run());
  const auto run = ExplorationLog(folder / "runs").find(in_the_hall, 3);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->outcome, "complete");
  EXPECT_EQ(run->free_iou, 0.1 + 0.2);
  EXPECT_EQ(run->sim_seconds, 61.25);
  EXPECT_EQ(run->hard_collisions, 2);
  EXPECT_EQ(run->phases, 7U);
  EXPECT_FALSE(run->wall_rmse_m);
}

TEST(ExplorationLog, KnowsARunByAllThatItIsAFunctionOf) {
  const tests::ScratchFolder folder;
  ExplorationLog log(folder / "runs");
  log.add(in_the_hall, 3, some_run());
  EXPECT_FALSE(log.find(in_the_hall, 4));
  auto what = in_the_hall;
  what.board = "mega";
  EXPECT_FALSE(log.find(what, 3));
  what = in_the_hall;
  what.strategy = "nxt-farthest";
  EXPECT_FALSE(log.find(what, 3));
}

TEST(ExplorationLog, KeepsNothingWithoutAFile) {
  ExplorationLog log;
  log.add(in_the_hall, 3, some_run());
  EXPECT_FALSE(log.find(in_the_hall, 3));
}

TEST(ExplorationLog, RefusesALineThatIsNoRun) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "runs", "{\"run\": \"hall\"}\n");
  EXPECT_THROW(ExplorationLog(folder / "runs"), std::runtime_error);
}

TEST(ExplorationLog, GoesOnBehindALastLineThatIsCutOff) {
  const tests::ScratchFolder folder;
  const auto path = folder / "runs";
  ExplorationLog(path).add(in_the_hall, 3, some_run());
  const std::string whole = files::read_text_file(path);
  ExplorationLog(path).add(in_the_hall, 4, some_run());
  const std::string both = files::read_text_file(path);
  for (const std::size_t bytes : {whole.size() + 1, both.size() - 20, both.size() - 1}) {
    files::write_text_file(path, both.substr(0, bytes));
    ExplorationLog log(path);
    EXPECT_TRUE(log.find(in_the_hall, 3)) << bytes;
    EXPECT_FALSE(log.find(in_the_hall, 4)) << bytes;
    log.add(in_the_hall, 4, some_run());
    EXPECT_EQ(files::read_text_file(path), both) << bytes;
  }
}

TEST(ExplorationLog, RefusesHalfALineInItsMiddle) {
  const tests::ScratchFolder folder;
  const auto path = folder / "runs";
  ExplorationLog(path).add(in_the_hall, 3, some_run());
  const std::string line = files::read_text_file(path);
  files::write_text_file(path, line.substr(0, 50) + "\n" + line);
  EXPECT_THROW(ExplorationLog{path}, std::runtime_error);
}

}  // namespace
}  // namespace echomap::bench
