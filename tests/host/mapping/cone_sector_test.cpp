// SPDX-License-Identifier: MIT
#include "host/mapping/cone_sector.hpp"

#include <string>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

/// Rows from the top down, columns -6 to 6; each cell's steps as a digit.
std::string drawing_of(const FacingSector& facing) {
  std::string drawn;
  for (auto row = facing.rows.rbegin(); row != facing.rows.rend(); ++row) {
    for (std::int32_t x = -6; x <= 6; ++x) {
      const bool is_in = x >= row->first && x <= row->last;
      const std::size_t steps = row->steps_begin + static_cast<std::size_t>(x - row->first);
      drawn += is_in ? std::to_string(facing.steps.at(steps)) : ".";
    }
    drawn += '\n';
  }
  return drawn.substr(drawn.find_first_not_of(".\n") / 14 * 14);
}

TEST(ConeSector, LaysTheStepsOutByTheAngle) {
  ConeSector sector({4, 2}, 0.7, 6);
  EXPECT_EQ(sector.facing(0).first_row, -3);
  EXPECT_EQ(drawing_of(sector.facing(0)),
            "..........22.\n"
            ".........222.\n"
            "........2444.\n"
            "......4444444\n"
            "........2444.\n"
            ".........222.\n"
            "..........22.\n");
  EXPECT_EQ(sector.facing(225).first_row, -5);
  EXPECT_EQ(drawing_of(sector.facing(225)),
            "......4......\n"
            ".22244.......\n"
            ".24444.......\n"
            ".44442.......\n"
            "..4442.......\n"
            "...422.......\n");
}

TEST(ConeSector, KnowsHowFarItReachesAlongTheAxes) {
  ConeSector sector({4}, 0.5, 3);
  EXPECT_DOUBLE_EQ(sector.facing(90).along_y.greatest, 1.0);
  EXPECT_NEAR(sector.facing(90).along_y.least, 0.8776, 1e-4);
  EXPECT_NEAR(sector.facing(90).along_x.greatest, 0.4794, 1e-4);
  EXPECT_NEAR(sector.facing(90).along_x.least, -0.4794, 1e-4);
  EXPECT_DOUBLE_EQ(sector.facing(190).along_x.least, -1.0);
}

TEST(ConeSector, SaysWhenItHasNoEvidence) {
  EXPECT_TRUE(ConeSector({}, 0.5, 3).empty());
  EXPECT_FALSE(ConeSector({1}, 0.5, 3).empty());
}

}  // namespace
}  // namespace echomap::mapping
