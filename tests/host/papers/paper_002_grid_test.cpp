// SPDX-License-Identifier: MIT
#include "host/papers/paper_002_grid.hpp"

#include <gtest/gtest.h>

#include "host/paper_report/source_lines.hpp"
#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper002GridExperiment, HasItsFiguresPicturesAndSources) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.runs = 2;
  settings.out = folder.path();
  const auto experiment = epuck_grid_experiment(settings);
  EXPECT_EQ(experiment.pictures.size(), 4U);
  const auto& wrong = tests::finding(experiment, "free that is no floor");
  EXPECT_LT(wrong.ours->value, wrong.as_told->value);
  EXPECT_LT(tests::finding(experiment, "walls found, by odds of 0.7 and 0.3").as_told->value,
            tests::finding(experiment, "walls found, within 3 mm").as_told->value);
  const paper_report::SourceLines sources(ECHOMAP_SOURCE_DIR, "");
  for (const auto& equation : experiment.equations) {
    EXPECT_TRUE(sources.line(equation.file, equation.symbol)) << equation.name;
  }
}

}  // namespace
}  // namespace echomap::papers
