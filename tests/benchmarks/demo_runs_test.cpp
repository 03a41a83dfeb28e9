// SPDX-License-Identifier: MIT
#include "tests/benchmarks/demo_runs.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/benchmarks/board_comparison.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

/// A stand-in for echomap that writes the same report for every seed but the second, where it does
/// as `at_second` says.
std::filesystem::path write_demo_program(const std::filesystem::path& path,
                                         const std::string& at_second) {
  std::ofstream(path) << R"(#!/bin/sh
for word; do
  case $word in
    --json=*) report=${word#--json=} ;;
    --seed=2) )" << at_second
                      << R"( ;;
  esac
done
echo '{"finished": true, "outcome": "complete", "emulator": "none 1.0", "free_iou": 0.9,
  "wall_rmse_m": 0.02, "wall_recall": 1, "ate_rmse_m": 0.01, "sim_seconds": 60, "wall_seconds": 1,
  "stops": 7}' > "$report"
)";
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

TEST(DemoRuns, ARunWithoutAReportIsOneThatDidNotEnd) {
  for (const char* end : {"exit 0", "echo '{' > \"$report\"; exit 0", "exit 1"}) {
    const tests::ScratchFolder folder;
    DemoRuns runs;
    runs.program = write_demo_program(folder / "demo", end);
    runs.seeds = 3;
    runs.jobs = 2;
    testing::internal::CaptureStderr();
    const DemoFigures demos = measure_demos(runs);
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                testing::HasSubstr("seed 2 did not end by itself:"))
        << end;
    EXPECT_EQ(value_of(demos.figures, "runs_ended"), 2.0) << end;
    EXPECT_EQ(value_of(demos.figures, "runs_finished"), 2.0) << end;
    EXPECT_EQ(value_of(demos.figures, "stops"), 7.0) << end;
  }
}

TEST(DemoRuns, AProgramThatCannotBeStartedEndsNoRun) {
  DemoRuns runs;
  runs.program = "/nowhere/echomap";
  runs.seeds = 2;
  testing::internal::CaptureStderr();
  EXPECT_EQ(value_of(measure_demos(runs).figures, "runs_ended"), 0.0);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::HasSubstr("seed 2 did not end by itself:"));
}

}  // namespace
}  // namespace echomap::bench
