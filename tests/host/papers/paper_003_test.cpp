// SPDX-License-Identifier: MIT
// Over 20 seeds, with room to the figures of `echomap paper 003`.
#include "host/papers/paper_003.hpp"

#include <gtest/gtest.h>

#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper003, ComesBackAndFindsWallsAndCone) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto report = paper_003(settings);
  ASSERT_EQ(report.experiments.size(), 3U);
  const auto& drive = report.experiments[0];
  EXPECT_GE(tests::finding(drive, "runs with all seven phases").ours->value, 50.0);
  EXPECT_LT(tests::finding(drive, "position at the end is off by").ours->value, 50.0);
  const auto& patches = report.experiments[1];
  EXPECT_GT(tests::finding(patches, "walls that are occupied").as_told->value, 95.0);
  EXPECT_GT(tests::finding(patches, "boxes that are occupied").as_told->value, 95.0);
  EXPECT_GT(tests::finding(patches, "occupied cells are off by").as_told->value, 5.0)
      << "patches are wider than walls";
  EXPECT_EQ(patches.pictures.size(), 1U);
  EXPECT_NEAR(tests::finding(report.experiments[2], "width of the cone").ours->value, 32.8, 3.0);
}

}  // namespace
}  // namespace echomap::papers
