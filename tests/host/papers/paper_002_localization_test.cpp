// SPDX-License-Identifier: MIT
#include "host/papers/paper_002_localization.hpp"

#include <gtest/gtest.h>

#include "host/paper_report/source_lines.hpp"
#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper002LocalizationExperiment, HasItsFiguresPicturesAndSources) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.runs = 2;
  settings.out = folder.path();
  const auto experiment = epuck_localization_experiment(settings);
  EXPECT_EQ(experiment.pictures.size(), 8U);
  const auto& right = tests::finding(experiment, "right at the end, by Neff");
  EXPECT_EQ(right.as_told->runs, 2U);
  EXPECT_EQ(right.ours->runs, 2U);
  const paper_report::SourceLines sources(ECHOMAP_SOURCE_DIR, "");
  for (const auto& equation : experiment.equations) {
    EXPECT_TRUE(sources.line(equation.file, equation.symbol)) << equation.name;
  }
}

}  // namespace
}  // namespace echomap::papers
