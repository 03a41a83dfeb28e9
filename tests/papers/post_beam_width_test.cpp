// SPDX-License-Identifier: MIT
#include "tests/papers/post_beam_width.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::papers {
namespace {

using geometry::radians;
using sensors::Beam;

constexpr PostBeamWidthParams kPostAt1M{1.0, 0.1, 0.0};

/// A sweep of one degree a step through the post at `post_deg`, which is heard up to `half_deg` off
/// it; a wall stands behind it.
std::vector<Beam> sharp_sweep(double post_deg, double half_deg) {
  std::vector<Beam> sweep;
  for (double off_deg = -60.0; off_deg <= 60.0; off_deg += 1.0) {
    const double range_m = std::abs(off_deg) <= half_deg ? 1.0 : 2.5;
    sweep.push_back({geometry::wrap_angle(radians(post_deg + off_deg)), range_m});
  }
  return sweep;
}

TEST(BeamWidthPastPost, IsTheAngleBetweenBothEdges) {
  for (const double half_deg : {6.25, 12.25, 20.25}) {
    const auto opening = beam_width_past_post(sharp_sweep(10.0, half_deg), kPostAt1M);
    ASSERT_TRUE(opening);
    EXPECT_NEAR(geometry::degrees(opening->beam_width_rad), 2.0 * half_deg, 1.0);
    EXPECT_LE(opening->low_rad, radians(2.0 * half_deg));
    EXPECT_GE(opening->high_rad, radians(2.0 * half_deg));
  }
}

TEST(BeamWidthPastPost, MayLieBehindTheRobot) {
  const auto opening = beam_width_past_post(sharp_sweep(180.0, 12.25), kPostAt1M);
  ASSERT_TRUE(opening);
  EXPECT_NEAR(geometry::degrees(opening->beam_width_rad), 24.5, 1.0);
}

TEST(BeamWidthPastPost, TakesThePostsOwnWidthOff) {
  const auto sweep = sharp_sweep(0.0, 12.25);
  const auto thin = beam_width_past_post(sweep, kPostAt1M);
  const auto thick = beam_width_past_post(sweep, {1.0, 0.1, 0.05});
  ASSERT_TRUE(thin && thick);
  EXPECT_NEAR(thin->beam_width_rad - thick->beam_width_rad, 0.05, 1e-4);
  EXPECT_NEAR(thin->high_rad - thick->high_rad, 0.05, 1e-4);
}

TEST(BeamWidthPastPost, OutlivesMissesAndStrayEchoes) {
  auto sweep = sharp_sweep(0.0, 15.25);
  for (std::size_t i = 3; i < sweep.size(); i += 7) {
    sweep[i].range_m.reset();
  }
  sweep[2].range_m = 1.05;
  const auto opening = beam_width_past_post(sweep, kPostAt1M);
  ASSERT_TRUE(opening);
  EXPECT_NEAR(geometry::degrees(opening->beam_width_rad), 30.5, 3.0);
}

TEST(BeamWidthPastPost, IsUnsureWhereReadingsAreFew) {
  const auto sweep = sharp_sweep(0.0, 15.25);
  std::vector<Beam> coarse;
  for (std::size_t i = 0; i < sweep.size(); i += 6) {
    coarse.push_back(sweep[i]);
  }
  const auto fine = beam_width_past_post(sweep, kPostAt1M);
  const auto rough = beam_width_past_post(coarse, kPostAt1M);
  ASSERT_TRUE(fine && rough);
  EXPECT_GT(rough->high_rad - rough->low_rad, 2.0 * (fine->high_rad - fine->low_rad));
}

TEST(BeamWidthPastPost, IsEmptyWhereThePostIsNotHeardOrHeardToTheEnd) {
  EXPECT_FALSE(beam_width_past_post(sharp_sweep(0.0, 0.5), kPostAt1M));
  EXPECT_FALSE(beam_width_past_post(sharp_sweep(0.0, 60.5), kPostAt1M));
  EXPECT_FALSE(beam_width_past_post({}, kPostAt1M));
}

TEST(BeamWidthByTilt, IsTwiceTheAngleOfTheEdge) {
  std::vector<Beam> tilts;
  for (double tilt_deg = 1.0; tilt_deg < 45.0; tilt_deg += 1.0) {
    tilts.push_back({radians(tilt_deg), tilt_deg < 16.5 ? 1.02 : 2.7});
  }
  const auto opening = beam_width_by_tilt(tilts, kPostAt1M);
  ASSERT_TRUE(opening);
  EXPECT_NEAR(geometry::degrees(opening->beam_width_rad), 33.0, 1.0);
}

TEST(BeamWidthPastPost, RefusesParametersWithoutSense) {
  EXPECT_THROW(beam_width_past_post({}, {0.0, 0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(beam_width_past_post({}, {1.0, 0.1, -0.1}), std::invalid_argument);
  EXPECT_THROW(beam_width_by_tilt({}, {1.0, 0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::papers
