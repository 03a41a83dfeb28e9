// SPDX-License-Identifier: MIT
// Over 20 seeds, with room to the figures of `echomap paper 001`.
#include "host/papers/paper_001.hpp"

#include <gtest/gtest.h>

#include "tests/host/papers/finding.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(Paper001, FindsTheCornersAndSeldomTheRobot) {
  const tests::ScratchFolder folder;
  PaperSettings settings;
  settings.out = folder.path();
  const auto report = paper_001(settings);
  ASSERT_EQ(report.experiments.size(), 3U);
  const auto& outlines = report.experiments[0];
  EXPECT_GE(tests::finding(outlines, "L: runs with as many corners as the room").ours->value, 50.0);
  EXPECT_LT(tests::finding(outlines, "L: corners are off by").ours->value, 8.0);
  EXPECT_LT(tests::finding(outlines, "T: corners are off by").ours->value, 10.0);
  EXPECT_EQ(outlines.pictures.size(), 4U);
  const auto& odometry = report.experiments[1];
  const double turn_deg =
      tests::finding(odometry, "turn error of a turn by 360 degrees").as_told->value;
  EXPECT_GT(turn_deg, 0.5);
  EXPECT_LT(turn_deg, 2.0);
  const auto& localization = report.experiments[2];
  EXPECT_LE(tests::finding(localization, "localized within 15 cm and 10 degrees").as_told->value,
            50.0);
  EXPECT_LT(tests::finding(localization, "particles outside of the room").ours->value, 20.0);
}

}  // namespace
}  // namespace echomap::papers
