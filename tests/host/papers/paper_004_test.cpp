// SPDX-License-Identifier: MIT
// Over 20 seeds, with room to the figures of `echomap paper 004`.
#include "host/papers/paper_004.hpp"

#include <gtest/gtest.h>

#include "host/paper_report/source_lines.hpp"
#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper004, EkfSlamIsNearerToTheTruthAndTheSourceIsFound) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto report = paper_004(settings);
  ASSERT_EQ(report.experiments.size(), 4U);
  const auto& hall = report.experiments[1];
  const auto& told = tests::finding(hall, "path by odometry is off by (RMS)").as_told;
  const auto& ours = tests::finding(hall, "path by EKF-SLAM is off by (RMS)").ours;
  EXPECT_LT(ours->high, told->low);
  EXPECT_LT(ours->value, 0.5 * told->value);
  const auto& room = report.experiments[2];
  const auto& path = tests::finding(room, "path is off by (RMS)");
  EXPECT_LT(path.ours->value, path.as_told->value);
  const auto& walls = tests::finding(room, "walls are off by");
  EXPECT_LT(walls.ours->value, walls.as_told->value);
  const auto& team = report.experiments[3];
  EXPECT_GE(tests::finding(team, "one robot has found the source").ours->value, 80.0);
  EXPECT_GE(tests::finding(team, "two robots have found it").ours->value, 80.0);
  EXPECT_GT(tests::finding(team, "floor that two robots' map and the truth share").ours->value,
            70.0);
  const paper_report::SourceLines lines(ECHOMAP_SOURCE_DIR);
  for (const auto& experiment : report.experiments) {
    for (const auto& equation : experiment.equations) {
      EXPECT_TRUE(lines.line(equation.file, equation.symbol).has_value()) << equation.name;
    }
  }
}

}  // namespace
}  // namespace echomap::papers
