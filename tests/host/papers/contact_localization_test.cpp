// SPDX-License-Identifier: MIT
// Mukherjee et al., section V: an iRobot Create that only feels its walls is looked for in the
// outline of its room while it bounces about.
#include "host/papers/contact_localization.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/reflex_outline.hpp"
#include "host/localization/contact_model.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/models/uniform_sum.hpp"
#include "tests/support/random_polygon.hpp"

namespace echomap::papers {
namespace {

constexpr int kCreateRuns = 10;

TEST(ContactLocalization, AlphasOfSeventyRunsAreOfThePapersSize) {
  const models::LinearOdometryMotionParams ours = mean_odometry_errors(1);
  const models::LinearOdometryMotionParams paper;
  std::cout << "alpha1 " << geometry::degrees(ours.alpha1_rad_per_m) * 0.36
            << " degrees in 360 mm, alpha2 " << 360.0 * ours.alpha2 << " degrees in 360, alpha3 "
            << ours.alpha3 << " mm a mm, alpha4 " << ours.alpha4_m_per_rad << " m a radian\n";
  for (const double ratio :
       {ours.alpha1_rad_per_m / paper.alpha1_rad_per_m, ours.alpha2 / paper.alpha2}) {
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2.0);
  }
  // The simulated Create's wheels are truer than the paper's.
  EXPECT_LT(ours.alpha3, paper.alpha3);
}

TEST(ContactLocalization, ASampleOfTheMeanErrorIsAQuarterOfIt) {
  const models::LinearOdometryMotionParams truth;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double mean = 0.0;
  for (int i = 0; i < 70; ++i) {
    const double b = truth.alpha3;
    mean += std::abs(models::uniform_sum_sample(b, [&] { return uniform(random); })) / 70;
  }
  EXPECT_NEAR(mean / truth.alpha3, 1.0 / mean_error_scale(), 0.06);
}

/// As the paper has it: half planes of the non-reflex corners' polygon, less all triangles.
bool contains_as_printed(const geometry::ReflexCut& cut, const Eigen::Vector2d& point_m) {
  const geometry::Polygon& outer_m = cut.outer_m;
  for (std::size_t i = 0; i < outer_m.size(); ++i) {
    const geometry::Segment side = geometry::side(outer_m, i);
    if (geometry::cross(side.to_m - side.from_m, point_m - side.from_m) < 0.0) {
      return false;
    }
  }
  return std::none_of(cut.parts_m.begin(), cut.parts_m.end(), [&](const auto& part_m) {
    return geometry::contains(part_m, point_m);
  });
}

TEST(ContactLocalization, TheOutlinesTestHoldsForSimpleRoomsOnly) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (const std::size_t corners : {5U, 8U, 16U}) {
    int wrong = 0;
    for (int i = 0; i < 300; ++i) {
      const geometry::Polygon outline_m = tests::random_polygon(random, corners);
      const geometry::ReflexCut cut = geometry::cut_reflex_corners(outline_m);
      const geometry::ReflexOutline outline(outline_m);
      bool is_right = true;
      for (int k = 0; k < 200; ++k) {
        const Eigen::Vector2d point_m(any(random), any(random));
        is_right &= contains_as_printed(cut, point_m) == outline.contains(point_m);
      }
      wrong += is_right ? 0 : 1;
    }
    std::cout << corners << " corners: " << wrong << " of 300 outlines told wrongly\n";
    EXPECT_GE(wrong, corners == 16U ? 200 : corners == 8U ? 5 : 0);
    EXPECT_LE(wrong, corners == 16U ? 299 : corners == 8U ? 60 : 0);
  }
  const geometry::ReflexCut cut = geometry::cut_reflex_corners(contact_room().room_m());
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d point_m(any(random), any(random));
    ASSERT_EQ(contains_as_printed(cut, point_m), contact_room().is_free(point_m))
        << point_m.transpose();
  }
}

struct ContactRates {
  int right = 0;  ///< Within 15 cm and 10 degrees.
  int about = 0;  ///< Within 50 cm and 30 degrees.
  double outside_share = 0.0;
};

ContactRates rates_of(const std::string& name, const ContactTrial& trial) {
  ContactRates rates;
  for (std::uint32_t seed = 1; seed <= kCreateRuns; ++seed) {
    const ContactOutcome outcome = localize_by_contacts(trial, seed);
    const double off_deg = geometry::degrees(outcome.heading_error_rad);
    rates.right += outcome.error_m < 0.15 && off_deg < 10.0 ? 1 : 0;
    rates.about += outcome.error_m < 0.5 && off_deg < 30.0 ? 1 : 0;
    rates.outside_share += outcome.outside_share / kCreateRuns;
  }
  std::cout << name << ": right " << rates.right << ", about " << rates.about << " of "
            << kCreateRuns << ", outside " << rates.outside_share << "\n";
  return rates;
}

TEST(ContactLocalization, FindsTheRobotByContactsWhereWhatIsResampledIsSpread) {
  const ContactRates as_told = rates_of("as it is told", {});
  const ContactRates meant = rates_of("alphas as mean errors", {.alpha_scale = mean_error_scale()});
  const ContactRates spread =
      rates_of("spread, resampled if the effective sample size is low, 2,000 particles",
               {.particles = 2000,
                .alpha_scale = mean_error_scale(),
                .likelihood_exponent = 0.3,
                .spread = 0.02,
                .resampling_share = 0.5});
  EXPECT_LE(as_told.right, 3);
  EXPECT_LE(meant.right, 5);
  EXPECT_GE(spread.right, 6);
  EXPECT_LT(spread.outside_share, 0.1);
}

double outside_share(const localization::Particles& particles) {
  double outside = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    outside += contact_room().is_free(particles.pose(i).position_m()) ? 0.0 : 1.0;
  }
  return outside / static_cast<double>(particles.size());
}

TEST(ContactLocalization, AParticleOutsideOfTheOutlineIsNotResampled) {
  const mapping::PolygonMap map(contact_room().room_m());
  localization::ContactModel model(map, 0.165);
  localization::MonteCarloLocalizer localizer(
      model,
      localization::localizer_params(localization::LocalizerPreset::kCreate, {}),
      std::mt19937(1));
  localizer.update({}, {});
  localizer.start_at({2.5, 1.2, 0.0}, 0.6, 1.0);
  EXPECT_GT(outside_share(localizer.particles()), 0.3);
  localizer.update({}, {});
  EXPECT_EQ(outside_share(localizer.particles()), 0.0);
}

}  // namespace
}  // namespace echomap::papers
