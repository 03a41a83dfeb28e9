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

/// Two places, half a metre before the ends of a corridor: of one end the wall is known, and of the
/// other what `right_end` draws.
double telling_of_ends(const std::string& right_end) {
  const std::string floor = "#" + std::string(20, '.') + right_end;
  const std::string walls(floor.size(), '#');
  const ViewDifference views(tests::map_from({walls, floor, floor, floor, floor, walls}, 0.1), 1.5);
  return views.telling({{{0.6, 0.3, std::numbers::pi}, Eigen::Matrix3d::Identity(), 0.5},
                        {{1.6, 0.3, 0.0}, Eigen::Matrix3d::Identity(), 0.5}},
                       {});
}

TEST(ViewDifference, IsNothingWhereTheMapDoesNotKnowWhatIsThere) {
  EXPECT_LT(telling_of_ends("####"), 0.02);
  EXPECT_LT(telling_of_ends("    "), 0.02);
  EXPECT_LT(telling_of_ends(""), 0.02) << "beyond the map nothing is known, either";
  EXPECT_GT(telling_of_ends("....    "), telling_of_ends("    ") + 0.02)
      << "floor that is known is no wall";
}

TEST(ViewDifference, IsNothingOutsideOfTheMap) {
  const ViewDifference views(kCorridor, 1.0);
  const std::vector<PoseHypothesis> places{at(1.5, 0.0, 0.5), at(2.5, 0.0, 0.5)};
  EXPECT_EQ(views.telling(places, Pose2(0.0, 40.0, 0.0)), 0.0);
}

TEST(ViewDifference, IsNothingForOnePlaceAloneAndForNone) {
  const ViewDifference views(kCorridor, 1.0);
  EXPECT_EQ(views.telling({at(1.5, 0.0, 1.0)}, {}), 0.0);
  EXPECT_EQ(views.telling({}, {}), 0.0);
}

}  // namespace
}  // namespace echomap::localization
