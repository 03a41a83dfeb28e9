// SPDX-License-Identifier: MIT
#include "tests/benchmarks/laser_to_sonar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::bench {
namespace {

using geometry::radians;

/// A laser of 180 degrees, four beams a degree, that sees `range_m(bearing)`.
template <typename Range>
sensors::RangeScan laser_seeing(Range&& range_m) {
  sensors::RangeScan scan;
  scan.stamp_s = 12.5;
  for (int quarter = -360; quarter <= 360; ++quarter) {
    const double bearing_rad = radians(0.25 * quarter);
    scan.beams.push_back({bearing_rad, range_m(bearing_rad)});
  }
  return scan;
}

/// A straight wall 1 m ahead.
std::optional<double> wall_ahead_m(double bearing_rad) {
  return std::abs(bearing_rad) < radians(75.0) ? std::optional(1.0 / std::cos(bearing_rad))
                                               : std::nullopt;
}

LaserToSonarParams quiet() {
  LaserToSonarParams params;
  params.noise_m = 0.0;
  params.noise_share = 0.0;
  params.second_bounce_chance = 0.0;
  return params;
}

sensors::RangeScan heard(const sensors::RangeScan& laser, const LaserToSonarParams& params) {
  std::mt19937 random(1);
  return heard_scan(laser, params, random).scan;
}

TEST(LaserToSonar, LooksInto24DirectionsOverTheField) {
  const auto sonar = heard(laser_seeing(wall_ahead_m), quiet());
  ASSERT_EQ(sonar.beams.size(), 24U);
  EXPECT_NEAR(sonar.beams.front().bearing_rad, radians(-86.25), 1e-9);
  EXPECT_NEAR(sonar.beams[1].bearing_rad - sonar.beams[0].bearing_rad, radians(7.5), 1e-9);
  EXPECT_EQ(sonar.stamp_s, 12.5);
  EXPECT_NEAR(sonar.beam_width_rad, radians(30.0), 1e-4);
}

TEST(LaserToSonar, HearsTheNearestInItsCone) {
  auto params = quiet();
  params.specular = false;
  const auto sonar = heard(laser_seeing(wall_ahead_m), params);
  for (const sensors::Beam& beam : sonar.beams) {
    const double nearest_rad = std::max(0.0, std::abs(beam.bearing_rad) - radians(15.0));
    if (nearest_rad < radians(65.0)) {
      ASSERT_TRUE(beam.range_m);
      EXPECT_NEAR(*beam.range_m, 1.0 / std::cos(nearest_rad), 0.06);
    }
  }
}

TEST(LaserToSonar, LosesASmoothWallBeyondThirtyDegreesOffTheAxis) {
  for (const sensors::Beam& beam : heard(laser_seeing(wall_ahead_m), quiet()).beams) {
    EXPECT_EQ(beam.range_m.has_value(), std::abs(beam.bearing_rad) < radians(30.5))
        << geometry::degrees(beam.bearing_rad);
  }
}

TEST(LaserToSonar, HearsAPostFromAnyDirectionWithinTheCone) {
  const auto post = laser_seeing([](double bearing_rad) {
    return std::abs(bearing_rad - radians(40.0)) < radians(0.6) ? std::optional(1.5) : std::nullopt;
  });
  for (const sensors::Beam& beam : heard(post, quiet()).beams) {
    EXPECT_EQ(beam.range_m.has_value(), std::abs(beam.bearing_rad - radians(40.0)) < radians(15.0));
  }
}

TEST(LaserToSonar, HearsNothingBeyondItsRange) {
  const auto far_wall = laser_seeing([](double) { return std::optional(3.2); });
  for (const sensors::Beam& beam : heard(far_wall, quiet()).beams) {
    EXPECT_FALSE(beam.range_m);
  }
}

// A corner: what the wall at the left throws aside meets the wall ahead.
TEST(LaserToSonar, HearsASecondBounceFartherThanTheWallItself) {
  const auto corner = laser_seeing([](double bearing_rad) {
    const double ahead_m = std::cos(bearing_rad) > 0.0 ? 2.5 / std::cos(bearing_rad) : 99.0;
    const double left_m = std::sin(bearing_rad) > 0.0 ? 0.5 / std::sin(bearing_rad) : 99.0;
    return std::optional(std::min(ahead_m, left_m));
  });
  auto params = quiet();
  params.beam_half_angle_rad = radians(4.0);
  params.smooth_limit_rad = radians(25.0);
  params.directions = 90;
  std::size_t silent = 0;
  for (const sensors::Beam& beam : heard(corner, params).beams) {
    silent += beam.range_m ? 0 : 1;
  }
  params.second_bounce_chance = 1.0;
  std::size_t still_silent = 0;
  for (const sensors::Beam& beam : heard(corner, params).beams) {
    still_silent += beam.range_m ? 0 : 1;
  }
  EXPECT_LT(still_silent, silent);
}

TEST(LaserToSonar, ReportsWhereEachEchoCameFrom) {
  std::mt19937 random(1);
  const auto sonar = heard_scan(laser_seeing(wall_ahead_m), quiet(), random);
  std::size_t echo = 0;
  for (const sensors::Beam& beam : sonar.scan.beams) {
    if (beam.range_m) {
      ASSERT_LT(echo, sonar.origins_m.size());
      EXPECT_NEAR(sonar.origins_m[echo].norm(), *beam.range_m, 1e-6);
      ++echo;
    }
  }
  EXPECT_GT(echo, 0U);
  EXPECT_EQ(echo, sonar.origins_m.size());
}

TEST(LaserToSonar, RepeatsItselfWithTheSameSeed) {
  const auto laser = laser_seeing(wall_ahead_m);
  EXPECT_EQ(heard(laser, {}).beams, heard(laser, {}).beams);
}

TEST(LaserToSonar, RefusesBeamsThatGoClockwise) {
  auto laser = laser_seeing(wall_ahead_m);
  std::reverse(laser.beams.begin(), laser.beams.end());
  EXPECT_THROW(heard(laser, {}), std::invalid_argument);
  EXPECT_THROW(heard({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench
