// SPDX-License-Identifier: MIT
// Over 20 seeds, with room to the figures of `echomap paper 000`.
#include "host/papers/paper_000.hpp"

#include <gtest/gtest.h>

#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper000, MapsLessThanOursAndIsSureWhereItIsWrong) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto report = paper_000(settings);
  ASSERT_EQ(report.experiments.size(), 2U);
  const auto& mapping = report.experiments[0];
  const auto& walls = tests::finding(mapping, "walls that the map has");
  EXPECT_GT(walls.as_told->value, 30.0);
  EXPECT_LT(walls.as_told->value, 80.0);
  EXPECT_GT(walls.ours->value, 85.0);
  EXPECT_LT(tests::finding(mapping, "walls are off by").ours->value,
            tests::finding(mapping, "walls are off by").as_told->value);
  const auto& localization = report.experiments[1];
  const auto& right = tests::finding(localization, "localized within 15 cm and 10 degrees");
  EXPECT_LE(right.as_told->value, 50.0);
  EXPECT_GE(right.ours->value, 50.0);
  EXPECT_GE(tests::finding(localization, "sure and wrong").as_told->value, 50.0);
  EXPECT_LE(tests::finding(localization, "sure and wrong").ours->value, 50.0);
  for (const auto& experiment : report.experiments) {
    EXPECT_EQ(experiment.pictures.size(), 2U) << experiment.title;
    EXPECT_FALSE(experiment.open.empty()) << experiment.title;
  }
}

}  // namespace
}  // namespace echomap::papers
