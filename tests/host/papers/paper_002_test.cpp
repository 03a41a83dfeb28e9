// SPDX-License-Identifier: MIT
// Over 20 seeds, with room to the figures of `echomap paper 002`.
#include "host/papers/paper_002.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper002, KnowsHowWellItIsLocalizedAndFindsMostWallsAndHalfOfTheStarts) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto report = paper_002(settings);
  ASSERT_EQ(report.experiments.size(), 3U);
  const auto& ekf = report.experiments[0];
  EXPECT_LT(tests::finding(ekf, "errors beyond 3 sigma").as_told->value, 0.6);
  EXPECT_LT(tests::finding(ekf, "errors beyond 3 sigma").ours->value, 0.6);
  EXPECT_LT(tests::finding(ekf, "estimated deviation, 76th iteration").ours->value, 5.0);
  const auto& grid = report.experiments[1];
  EXPECT_NEAR(tests::finding(grid, "walls found, within 3 mm").as_told->value, 88.0, 5.0);
  EXPECT_GT(tests::finding(grid, "floor found, small clots called free").as_told->value,
            tests::finding(grid, "floor found").as_told->value);
  EXPECT_GT(tests::finding(grid, "the same, small clots called free").as_told->value, 25.0);
  EXPECT_LT(tests::finding(grid, "free that is no floor").ours->value, 3.0);
  const auto& localization = report.experiments[2];
  for (const char* const way : {", resampled at every step", ", by Neff"}) {
    const auto right = tests::finding(localization, std::string("right at the end") + way);
    EXPECT_GE(right.as_told->value, 25.0) << way;
    EXPECT_LE(right.as_told->value, 85.0) << way;
    const auto beyond = tests::finding(localization, std::string("errors beyond 3 sigma") + way);
    EXPECT_LT(beyond.as_told->value, 1.0) << way;
  }
  const auto& wrong = tests::finding(localization, "converged to a wrong place, by Neff");
  EXPECT_GT(wrong.ours->value, wrong.as_told->value);
  EXPECT_LT(tests::finding(localization, "iterations that Neff converges later").as_told->value,
            60.0);
}

}  // namespace
}  // namespace echomap::papers
