// SPDX-License-Identifier: MIT
#include "host/mapping/arc_voting.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using geometry::Pose2;

const SonarFeature kNorthWall{true, {1.5707963, 2.0}};
const SonarFeature kEastWall{true, {0.0, 3.0}};
const SonarFeature kPost{false, {1.0, -1.0}};

/// What a sonar with a turning beam hears from some places: the nearest feature within its beam.
std::vector<PlacedReading> heard_of(const std::vector<SonarFeature>& features,
                                    const std::vector<Eigen::Vector2d>& places_m,
                                    double noise_sd_m,
                                    std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise_m(0.0, noise_sd_m);
  const ArcVotingParams params;
  std::vector<PlacedReading> readings;
  for (const auto& place_m : places_m) {
    for (int step = 0; step < 60; ++step) {
      const double axis_rad = geometry::wrap_angle(geometry::radians(6.0 * step));
      const Pose2 T_map_sonar(place_m.x(), place_m.y(), axis_rad);
      PlacedReading reading{{place_m.x(), place_m.y(), 0.0}, T_map_sonar, std::nullopt};
      for (const SonarFeature& feature : features) {
        const FeatureView view = view_from(place_m, feature);
        const double off_rad = geometry::angle_between(axis_rad, view.bearing_rad);
        if (std::abs(off_rad) < params.beam_half_angle_rad && view.range_m > 0.0 &&
            (!reading.range_m || view.range_m < *reading.range_m)) {
          reading.range_m = view.range_m;
        }
      }
      if (reading.range_m) {
        *reading.range_m += noise_m(random);
      }
      readings.push_back(reading);
    }
  }
  return readings;
}

const std::vector<Eigen::Vector2d> kPlaces{
    {0.0, 0.0}, {0.6, 0.3}, {-0.5, 0.4}, {0.2, -0.6}, {1.2, 0.5}, {1.6, -0.2}};

/// How many of the features, seen from another frame, are this one to 5 cm and 3 degrees.
std::ptrdiff_t count_of(const SonarFeature& expected,
                        const std::vector<VotedFeature>& features,
                        const Pose2& T_new_old = {}) {
  return std::count_if(features.begin(), features.end(), [&](const VotedFeature& voted) {
    const Eigen::Vector2d& parameters = voted.feature.parameters;
    if (voted.feature.is_wall != expected.is_wall) {
      return false;
    }
    if (!expected.is_wall) {
      return (parameters - T_new_old * expected.parameters).norm() < 0.05;
    }
    const double turn_rad =
        geometry::angle_between(expected.parameters.x() + T_new_old.heading_rad(), parameters.x());
    const double old_offset_m =
        parameters.y() - geometry::unit_vector(parameters.x()).dot(T_new_old.position_m());
    return std::abs(turn_rad) < 0.05 && std::abs(old_offset_m - expected.parameters.y()) < 0.05;
  });
}

TEST(ArcVoting, FindsWallsAndAPost) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const auto features =
        vote_for_features(heard_of({kNorthWall, kEastWall, kPost}, kPlaces, 0.01, seed));
    EXPECT_EQ(features.size(), 3U) << seed;
    for (const SonarFeature& expected : {kNorthWall, kEastWall, kPost}) {
      EXPECT_EQ(count_of(expected, features), 1) << seed;
    }
  }
}

TEST(ArcVoting, FindsTheSameFeaturesWhereverTheMapsOriginIs) {
  const auto readings = heard_of({kNorthWall, kEastWall, kPost}, kPlaces, 0.01, 3);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Pose2 T_new_old(any(random), any(random), any(random));
    auto moved = readings;
    for (auto& reading : moved) {
      reading.T_map_robot = T_new_old * reading.T_map_robot;
      reading.T_map_sonar = T_new_old * reading.T_map_sonar;
    }
    const auto features = vote_for_features(moved);
    EXPECT_LE(features.size(), 4U) << trial << ": other cells, maybe one ghost";
    for (const SonarFeature& expected : {kNorthWall, kEastWall, kPost}) {
      EXPECT_EQ(count_of(expected, features, T_new_old), 1) << trial;
    }
  }
}

TEST(ArcVoting, KnowsAboutHowSureItIs) {
  // Bearings here are off by the steps of the sweep alone, so that it may be surer than it says.
  constexpr int kRuns = 300;
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  Eigen::Matrix2d said = Eigen::Matrix2d::Zero();
  for (std::uint32_t seed = 1; seed <= kRuns; ++seed) {
    const auto features = vote_for_features(heard_of({kNorthWall}, kPlaces, 0.03, seed));
    ASSERT_GE(features.size(), 1U) << seed;
    const Eigen::Vector2d off = features[0].feature.parameters - kNorthWall.parameters;
    squares += off.cwiseProduct(off) / kRuns;
    said += features[0].covariance / kRuns;
  }
  for (const int i : {0, 1}) {
    EXPECT_LT(squares[i], 1.5 * said(i, i)) << i;
    EXPECT_GT(squares[i], 0.2 * said(i, i)) << i;
  }
}

TEST(ArcVoting, GivesEachReturnToOneFeature) {
  const auto readings = heard_of({kNorthWall, kEastWall, kPost}, kPlaces, 0.02, 5);
  std::vector<int> owners(readings.size(), 0);
  for (const auto& voted : vote_for_features(readings)) {
    for (const std::size_t i : voted.supporters) {
      ++owners[i];
      EXPECT_TRUE(readings[i].range_m);
    }
  }
  EXPECT_LE(*std::max_element(owners.begin(), owners.end()), 1);
}

TEST(ArcVoting, HearsNothingFromTooFewPlaces) {
  const auto readings = heard_of({kNorthWall}, {{0.0, 0.0}, {0.6, 0.3}}, 0.01, 6);
  EXPECT_TRUE(vote_for_features(readings).empty());
  EXPECT_TRUE(vote_for_features({}).empty());
  EXPECT_TRUE(vote_for_features(heard_of({}, kPlaces, 0.01, 7)).empty()) << "no echo at all";
}

TEST(ArcVoting, MakesNothingOfGhosts) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> range_m(0.3, 3.0);
  auto readings = heard_of({}, kPlaces, 0.01, 9);
  for (std::size_t i = 0; i < readings.size(); i += 6) {
    readings[i].range_m = range_m(random);
  }
  EXPECT_TRUE(vote_for_features(readings).empty());
}

TEST(ArcVoting, ChecksItsParameters) {
  ArcVotingParams params;
  params.bearing_step_rad = 0.0;
  EXPECT_THROW(vote_for_features({}, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
