// SPDX-License-Identifier: MIT
#include "host/tracking/pose_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echomap::tracking {
namespace {

using localization::LocalizationStatus;

localization::PoseBelief belief() {
  localization::PoseBelief belief;
  belief.status = LocalizationStatus::kLocalized;
  belief.lost_probability = 0.125;
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  belief.hypotheses.push_back({{1.5, -0.25, 0.0}, covariance, 0.875});
  return belief;
}

TEST(PoseReport, NamesEveryStatus) {
  EXPECT_EQ(name_of(LocalizationStatus::kLost), "lost");
  EXPECT_EQ(name_of(LocalizationStatus::kRecovering), "recovering");
  EXPECT_EQ(name_of(LocalizationStatus::kLocalized), "localized");
}

TEST(PoseReport, SaysWhereTheRobotIsAndHowLikelyNot) {
  EXPECT_EQ(text_of(belief()),
            "localized, 1.50, -0.25 m, 0 degrees (not there with probability 0.12)");
  EXPECT_EQ(text_of(localization::PoseBelief{}), "recovering, it may be anywhere");
}

TEST(PoseReport, NamesThePlacesThatFit) {
  localization::PoseBelief two = belief();
  two.status = LocalizationStatus::kRecovering;
  two.hypotheses.front().probability = 0.55;
  two.hypotheses.push_back({{3.0, 1.0, 3.14159}, Eigen::Matrix3d::Identity(), 0.44});
  two.hypotheses.push_back({{2.0, 1.0, 0.0}, Eigen::Matrix3d::Identity(), 0.01});
  EXPECT_EQ(places_that_fit(two), 2U);
  EXPECT_EQ(text_of(two),
            "recovering, 2 places fit: A 1.50, -0.25 m, 0 degrees (0.55); B 3.00, 1.00 m, 180 "
            "degrees (0.44)");
}

TEST(PoseReport, HoldsEveryHypothesisWithItsDeviations) {
  const auto json = to_json(belief());
  EXPECT_EQ(json.at("status"), "localized");
  EXPECT_EQ(json.at("lost_probability"), 0.125);
  const auto& first = json.at("hypotheses").at(0);
  EXPECT_EQ(first.at("x_m"), 1.5);
  EXPECT_NEAR(first.at("std_x_m").get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(first.at("std_y_m").get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(first.at("std_heading_rad").get<double>(), 0.3, 1e-12);
  EXPECT_EQ(first.at("probability"), 0.875);
}

}  // namespace
}  // namespace echomap::tracking
