// SPDX-License-Identifier: MIT
#include "host/slam/landmark_update.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

LandmarkSighting sure_point(double range_m, double bearing_rad) {
  LandmarkSighting sighting;
  sighting.value = {range_m, bearing_rad};
  sighting.noise = 1e-4 * Eigen::Matrix2d::Identity();
  return sighting;
}

TEST(LandmarkUpdate, AddsWhatHasBeenSeenOftenEnoughAndThenCountsIt) {
  EkfSlamFilter filter;
  LandmarkUpdate update({.provisional = {.sightings = 2}});
  const std::vector<LandmarkSighting> seen{sure_point(2.0, 0.3)};
  update.add_sightings(seen, {}, filter);
  EXPECT_TRUE(filter.landmarks().empty());
  update.add_sightings(seen, {}, filter);
  ASSERT_EQ(filter.landmarks().size(), 1U);
  update.add_sightings(seen, {}, filter);
  EXPECT_EQ(filter.landmarks().front().sightings, 2U);
  EXPECT_EQ(filter.landmarks().size(), 1U);
}

TEST(LandmarkUpdate, IsMoreSurprisedTheFartherALandmarkIsOff) {
  const auto negative_log_evidence_at = [](double range_m) {
    EkfSlamFilter filter;
    filter.add(sure_point(2.0, 0.3));
    LandmarkUpdate update;
    return update.add_sightings(
        std::vector<LandmarkSighting>{sure_point(range_m, 0.3)}, {}, filter);
  };
  EXPECT_LT(negative_log_evidence_at(2.0), negative_log_evidence_at(2.02));
  EXPECT_LT(negative_log_evidence_at(2.02), negative_log_evidence_at(3.0))
      << "that is of no landmark";
  EXPECT_EQ(negative_log_evidence_at(3.0), negative_log_evidence_at(4.0))
      << "as likely from anywhere";
}

TEST(LandmarkUpdate, RefusesGatesThatAreNone) {
  EXPECT_THROW(LandmarkUpdate({.association = {.gate = 0.0}}), std::invalid_argument);
  EXPECT_THROW(LandmarkUpdate({.association = {.gate_of_new = 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
