// SPDX-License-Identifier: MIT
#include "host/localization/view_difference.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// A corridor of 4.0 x 0.8 m with a niche near its right end.
const mapping::RasterMap kCorridor = tests::map_from({"########################################",
                                                      "##############################....######",
                                                      "##############################....######",
                                                      "##############################....######",
                                                      "##############################....######",
                                                      "#......................................#",
                                                      "#......................................#",
                                                      "#......................................#",
                                                      "#......................................#",
                                                      "#......................................#",
                                                      "#......................................#",
                                                      "########################################"},
                                                     0.1);

PoseHypothesis at(double x_m, double heading_rad, double probability) {
  return {{x_m, 0.4, heading_rad}, Eigen::Matrix3d::Identity(), probability};
}

TEST(ViewDifference, IsGreatestWhereOnlyOneOfTwoPlacesHasTheNiche) {
  const ViewDifference views(kCorridor, 1.0);
  const std::vector<PoseHypothesis> places{at(1.5, 0.0, 0.5), at(2.5, std::numbers::pi, 0.5)};
  const double here = views.telling(places, {});
  const double at_the_niche = views.telling(places, Pose2(1.6, 0.0, 0.0));
  EXPECT_GT(at_the_niche, here + 0.05);
}

/// Two places at the ends of a corridor of which one end is open, and may have a wall as well.
TEST(ViewDifference, IsNothingWhereTheMapKnowsNotWhatIsSeen) {
  const std::string row = "#" + std::string(24, '.') + "#";
  const std::string open_row = "#" + std::string(24, '.') + "    ";
  const std::string walls(28, '#');
  const auto telling = [&](const std::string& floor) {
    const ViewDifference views(tests::map_from({walls, floor, floor, floor, floor, walls}, 0.1),
                               2.0);
    return views.telling({{{0.6, 0.3, std::numbers::pi}, Eigen::Matrix3d::Identity(), 0.5},
                          {{2.0, 0.3, 0.0}, Eigen::Matrix3d::Identity(), 0.5}},
                         {});
  };
  EXPECT_LT(telling(open_row), 0.02);
  EXPECT_LT(telling(row + "##"), 0.02);
  EXPECT_GT(telling("#" + std::string(18, '.') + "####    #"), 0.02);
}

TEST(ViewDifference, IsNothingForOnePlaceAloneAndForNone) {
  const ViewDifference views(kCorridor, 1.0);
  EXPECT_EQ(views.telling({at(1.5, 0.0, 1.0)}, {}), 0.0);
  EXPECT_EQ(views.telling({}, {}), 0.0);
}

}  // namespace
}  // namespace echomap::localization
