// SPDX-License-Identifier: MIT
#include "host/localization/view_difference.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// A corridor of 4.0 x 0.8 m with a niche near its right end.
const mapping::RasterMap kCorridor = tests::map_from({"##############################    ######",
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

TEST(ViewDifference, IsNothingForOnePlaceAloneAndForNone) {
  const ViewDifference views(kCorridor, 1.0);
  EXPECT_EQ(views.telling({at(1.5, 0.0, 1.0)}, {}), 0.0);
  EXPECT_EQ(views.telling({}, {}), 0.0);
}

}  // namespace
}  // namespace echomap::localization
