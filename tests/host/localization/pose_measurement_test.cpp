// SPDX-License-Identifier: MIT
#include "host/localization/pose_measurement.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

const PoseGaussian belief{{1.0, 1.0, 3.1}, 0.04 * Eigen::Matrix3d::Identity()};

TEST(PoseMeasurement, InnovationOfAFixIsShortestAroundTheCircle) {
  const auto linear = linearized(PoseFix{0.0, {1.1, 0.9, -3.1}}, belief.T_map_robot);
  ASSERT_TRUE(linear);
  EXPECT_NEAR(linear->innovation(0), 0.1, 1e-12);
  EXPECT_NEAR(linear->innovation(2), 2.0 * geometry::radians(180.0) - 6.2, 1e-12);
}

TEST(PoseMeasurement, InnovationOfALandmarkIsWhatWasSeenLessWhatWasExpected) {
  const LandmarkObservation seen{.landmark_m = {3.0, 1.0}, .range_m = 2.1, .bearing_rad = -3.0};
  const auto linear = linearized(seen, belief.T_map_robot);
  ASSERT_TRUE(linear);
  EXPECT_NEAR(linear->innovation(0), 0.1, 1e-12);
  EXPECT_NEAR(linear->innovation(1), 0.1, 1e-12);
}

TEST(PoseMeasurement, AFixAsSureAsTheBeliefMeetsItHalfWay) {
  const PoseFix fix{0.0, {1.2, 1.0, 3.1}, belief.covariance};
  const auto linear = linearized(fix, belief.T_map_robot);
  const PoseGaussian after = corrected(belief, *linear);
  EXPECT_NEAR(after.T_map_robot.x_m(), 1.1, 1e-12);
  EXPECT_TRUE(after.covariance.isApprox(0.5 * belief.covariance, 1e-12));
  EXPECT_NEAR(squared_distance(belief, *linear), 0.04 / 0.08, 1e-12);
}

TEST(PoseMeasurement, ALandmarkTellsOfItsDirectionAndNothingAlongTheCircleAroundIt) {
  const LandmarkObservation seen{
      .landmark_m = {2.0, 0.0}, .range_m = 2.0, .range_stddev_m = 1e-4, .bearing_stddev_rad = 10.0};
  const PoseGaussian before{{}, 0.01 * Eigen::Matrix3d::Identity()};
  const PoseGaussian after = corrected(before, *linearized(seen, before.T_map_robot));
  EXPECT_LT(after.covariance(0, 0), 1e-7);
  EXPECT_NEAR(after.covariance(1, 1), 0.01, 1e-4);
}

TEST(PoseMeasurement, NamesItsFaults) {
  const double nan = std::nan("");
  PoseFix fix;
  EXPECT_FALSE(fault_of(fix));
  fix.covariance(1, 1) = -1.0;
  EXPECT_EQ(fault_of(fix), MeasurementFault::kBadCovariance);
  EXPECT_EQ(fault_of(PoseFix{nan, {}}), MeasurementFault::kNotFinite);
  EXPECT_EQ(fault_of(PoseFix{0.0, {0.0, nan, 0.0}}), MeasurementFault::kNotFinite);
  EXPECT_FALSE(fault_of(LandmarkObservation{.range_m = 1.0}));
  EXPECT_EQ(fault_of(LandmarkObservation{.range_m = nan}), MeasurementFault::kNotFinite);
  EXPECT_EQ(fault_of(LandmarkObservation{.range_m = 0.0}), MeasurementFault::kBadRange);
  EXPECT_EQ(fault_of(LandmarkObservation{.range_m = 1.0, .bearing_stddev_rad = 0.0}),
            MeasurementFault::kBadCovariance);
}

TEST(PoseMeasurement, OfALandmarkUnderTheRobotIsNone) {
  EXPECT_FALSE(linearized(LandmarkObservation{.landmark_m = {1.0, 1.0}, .range_m = 0.1},
                          belief.T_map_robot));
}

}  // namespace
}  // namespace echomap::localization
