// SPDX-License-Identifier: MIT
#include "tests/hil/measure/line_load.hpp"

#include <cstdio>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

class UsualLineLoad : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, UsualLineLoad, every_board(), image_label);

TEST_P(UsualLineLoad, BringsEverythingInLessThanAFifthOfTheLine) {
  const UsualLine line = measure_usual_line(release_image(GetParam()));
  std::printf("%.2f %% of 115200 baud; %.1f odometry/s, %.1f echoes/s, %.1f Status/s\n",
              100.0 * line.share,
              line.odometry_per_s,
              line.echoes_per_s,
              line.status_per_s);
  EXPECT_LE(line.share, 0.18);
  EXPECT_NEAR(line.odometry_per_s, 100.0, 0.5);
  EXPECT_NEAR(line.echoes_per_s, 25.0, 0.3);
  EXPECT_NEAR(line.status_per_s, 5.0, 0.3);
  EXPECT_EQ(line.rate_step, 0);
  EXPECT_EQ(line.dropped, 0);
}

TEST_P(UsualLineLoad, PingsAWallAtFourMetresTwentyFiveTimesASecond) {
  EXPECT_GE(measure_pings_per_s(release_image(GetParam())), 25.0);
}

}  // namespace
}  // namespace echomap::tests
