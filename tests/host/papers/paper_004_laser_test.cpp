// SPDX-License-Identifier: MIT
#include "host/papers/paper_004_laser.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/paper_report/source_lines.hpp"
#include "tests/host/papers/finding.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

using testing::HasSubstr;

void expect_sources(const paper_report::Experiment& experiment) {
  const paper_report::SourceLines lines(ECHOMAP_SOURCE_DIR);
  for (const paper_report::Equation& equation : experiment.equations) {
    EXPECT_TRUE(lines.line(equation.file, equation.symbol).has_value()) << equation.name;
  }
}

TEST(EdmontonExperiment, SaysWhatToPutWhereIfTheLogIsAbsent) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder / "out";
  const auto experiment = edmonton_experiment(settings, folder.path());
  EXPECT_THAT(experiment.answer, HasSubstr("Not repeated"));
  EXPECT_THAT(experiment.answer, HasSubstr((folder / "edmonton").string()));
  EXPECT_THAT(experiment.answer, HasSubstr("_ODO.txt"));
  EXPECT_TRUE(experiment.findings.empty());
  EXPECT_TRUE(experiment.pictures.empty());
  expect_sources(experiment);
}

TEST(EdmontonExperiment, EkfSlamErrsByAThirdOfOdometry) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("edmonton/dataset_edmonton.rawlog_LASER.txt.gz"));
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations/edm.assoc.gz"));
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto experiment = edmonton_experiment(settings, tests::real_data(""));
  const auto& odometry = tests::finding(experiment, "motion between scans is off by, odometry");
  EXPECT_GT(odometry.as_told->value, 25.0);
  EXPECT_NEAR(odometry.ours->value, 26.2, 0.05);
  const auto& turn = tests::finding(experiment, "turn between scans is off by, odometry");
  EXPECT_GT(turn.as_told->value, 2.0);
  EXPECT_LT(tests::finding(experiment, "motion between scans is off by, EKF-SLAM").ours->value,
            10.0);
  EXPECT_LT(tests::finding(experiment, "turn between scans is off by, EKF-SLAM").ours->value, 1.2);
  EXPECT_GT(tests::finding(experiment, "landmarks that are walls").ours->value, 50.0);
  ASSERT_EQ(experiment.pictures.size(), 1U);
  EXPECT_GT(experiment.pictures[0].png.size(), 10000U);
}

TEST(HallExperiment, EkfSlamIsNearerToTheTruthThanOdometry) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  settings.runs = 2;
  const auto experiment = hall_experiment(settings);
  const double told_cm =
      tests::finding(experiment, "path by odometry is off by (RMS)").as_told->value;
  EXPECT_LT(tests::finding(experiment, "path by EKF-SLAM is off by (RMS)").ours->value,
            0.5 * told_cm);
  EXPECT_EQ(experiment.pictures.size(), 1U);
  expect_sources(experiment);
}

}  // namespace
}  // namespace echomap::papers
