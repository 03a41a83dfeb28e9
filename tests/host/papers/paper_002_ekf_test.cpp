// SPDX-License-Identifier: MIT
#include "host/papers/paper_002_ekf.hpp"

#include <gtest/gtest.h>

#include "host/paper_report/source_lines.hpp"
#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper002EkfExperiment, HasItsFiguresPicturesAndSources) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.runs = 2;
  settings.out = folder.path();
  const auto experiment = epuck_ekf_experiment(settings);
  EXPECT_EQ(experiment.pictures.size(), 6U);
  const auto& narrow = tests::finding(experiment, "estimated deviation, 76th iteration");
  EXPECT_LT(narrow.as_told->value, narrow.ours->value) << "the late camera says less";
  const auto& blind = tests::finding(experiment, "camera stops at the 80th: deviation at the end");
  EXPECT_GT(blind.as_told->value, narrow.as_told->value);
  const paper_report::SourceLines sources(ECHOMAP_SOURCE_DIR, "");
  for (const auto& equation : experiment.equations) {
    EXPECT_TRUE(sources.line(equation.file, equation.symbol)) << equation.name;
  }
}

}  // namespace
}  // namespace echomap::papers
