// SPDX-License-Identifier: MIT
// Mukherjee et al., section V: an iRobot Create that only feels its walls is looked for in the
// outline of its room while it bounces about.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/reflex_outline.hpp"
#include "host/localization/contact_model.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/models/uniform_sum.hpp"
#include "tests/papers/bounce_drive.hpp"
#include "tests/support/random_polygon.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr int kObservations = 70;
constexpr int kCreateRuns = 10;
constexpr int kBumps = 25;
/// Of a normal number: the mean of its absolute value by its deviation.
const double kMeanByStddev = std::sqrt(2.0 / std::numbers::pi);

/// A room of our own with one reflex corner and no symmetry.
const world::FloorPlan& room() {
  static const world::FloorPlan plan(
      "outline",
      {{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.6}, {2.2, 1.6}, {1.7, 2.6}, {0.0, 2.6}}, {}},
      {},
      Pose2(1.0, 1.0, 0.0));
  return plan;
}

/// The paper's alphas as "mean errors" of drives of 360 mm and turns of 360 degrees.
models::LinearOdometryMotionParams mean_errors(std::uint32_t seed) {
  const world::RobotParams robot = create_robot();
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  constexpr double kDriveM = 0.36;
  constexpr double kTurnRad = 2.0 * std::numbers::pi;
  models::LinearOdometryMotionParams alphas{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < kObservations; ++i) {
    WheelErrors errors(robot.drive, noise);
    const Pose2 drive = errors.told(0.0, kDriveM);
    const Pose2 turn = errors.told(kTurnRad, 0.0);
    alphas.alpha1_rad_per_m += std::abs(drive.heading_rad()) / kDriveM / kObservations;
    alphas.alpha2 += std::abs(turn.heading_rad()) / kTurnRad / kObservations;
    alphas.alpha3 += std::abs(drive.x_m() - kDriveM) / kDriveM / kObservations;
    alphas.alpha4_m_per_rad += turn.position_m().norm() / kTurnRad / kObservations;
  }
  return alphas;
}

TEST(Paper001Localization, AlphasOfSeventyRunsAreOfThePapersSize) {
  const models::LinearOdometryMotionParams ours = mean_errors(1);
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

TEST(Paper001Localization, ASampleOfTheMeanErrorIsAQuarterOfIt) {
  const models::LinearOdometryMotionParams truth;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double mean = 0.0;
  for (int i = 0; i < kObservations; ++i) {
    const double b = truth.alpha3;
    mean +=
        std::abs(models::uniform_sum_sample(b, [&] { return uniform(random); })) / kObservations;
  }
  EXPECT_NEAR(mean / truth.alpha3, kMeanByStddev / 3.0, 0.06);
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

TEST(Paper001Localization, TheOutlinesTestHoldsForSimpleRoomsOnly) {
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
  const geometry::ReflexCut cut = geometry::cut_reflex_corners(room().room_m());
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d point_m(any(random), any(random));
    ASSERT_EQ(contains_as_printed(cut, point_m), room().is_free(point_m)) << point_m.transpose();
  }
}

/// What is tried beside the paper's text.
struct CreateTrial {
  std::size_t particles = 1000;
  double alpha_scale = 1.0;
  double likelihood_exponent = 1.0;
  double spread = 0.0;  ///< Metres and radians.
  double resampling_share = 1.0;
};

localization::LocalizerParams create_params_of(const CreateTrial& trial) {
  auto params = localization::localizer_params(localization::LocalizerPreset::kCreate, {});
  models::LinearOdometryMotionParams alphas;
  for (double* const alpha :
       {&alphas.alpha1_rad_per_m, &alphas.alpha2, &alphas.alpha3, &alphas.alpha4_m_per_rad}) {
    *alpha *= trial.alpha_scale;
  }
  params.motion = models::LinearOdometryMotion(alphas);
  params.filter.min_particles = trial.particles;
  params.filter.max_particles = trial.particles;
  params.filter.likelihood_exponent = trial.likelihood_exponent;
  params.filter.spread_m = trial.spread;
  params.filter.spread_rad = trial.spread;
  params.filter.resampling_share = trial.resampling_share;
  return params;
}

struct CreateRates {
  int right = 0;               ///< Within 15 cm and 10 degrees.
  int about = 0;               ///< Within 50 cm and 30 degrees.
  double outside_share = 0.0;  ///< Of the particles, after they were drawn.
};

double outside_share(const localization::Particles& particles) {
  double outside = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    outside += room().is_free(particles.pose(i).position_m()) ? 0.0 : 1.0;
  }
  return outside / static_cast<double>(particles.size());
}

CreateRates create_rates_of(const std::string& name, const CreateTrial& trial) {
  const mapping::PolygonMap map(room().room_m());
  CreateRates rates;
  for (std::uint32_t seed = 1; seed <= kCreateRuns; ++seed) {
    localization::ContactModel model(map, create_robot().body.radius_m);
    localization::MonteCarloLocalizer localizer(model, create_params_of(trial), std::mt19937(seed));
    BounceRobot robot(room(), seed);
    while (robot.bumps() < kBumps) {
      robot.step(0.15);
      model.add_contact(robot.contacts());
      localizer.update(robot.T_odom_robot(), {});
    }
    const Pose2& found = localizer.belief().hypotheses.at(0).T_map_robot;
    const double error_m = (found.position_m() - robot.T_world_robot().position_m()).norm();
    const double off_deg = std::abs(geometry::degrees(
        geometry::angle_between(found.heading_rad(), robot.T_world_robot().heading_rad())));
    rates.right += error_m < 0.15 && off_deg < 10.0 ? 1 : 0;
    rates.about += error_m < 0.5 && off_deg < 30.0 ? 1 : 0;
    rates.outside_share += outside_share(localizer.particles()) / kCreateRuns;
  }
  std::cout << name << ": right " << rates.right << ", about " << rates.about << " of "
            << kCreateRuns << ", outside " << rates.outside_share << "\n";
  return rates;
}

TEST(Paper001Localization, FindsTheRobotByContactsWhereWhatIsDrawnIsSpread) {
  const CreateRates told = create_rates_of("as it is told", {});
  const CreateRates meant =
      create_rates_of("alphas as mean errors", {.alpha_scale = 3.0 / kMeanByStddev});
  const CreateRates spread =
      create_rates_of("spread, drawn if the effective sample size is low, 2,000 particles",
                      {.particles = 2000,
                       .alpha_scale = 3.0 / kMeanByStddev,
                       .likelihood_exponent = 0.3,
                       .spread = 0.02,
                       .resampling_share = 0.5});
  EXPECT_LE(told.right, 3);
  EXPECT_LE(meant.right, 5);
  EXPECT_GE(spread.right, 6);
  EXPECT_LT(spread.outside_share, 0.1);
}

TEST(Paper001Localization, AParticleOutsideOfTheOutlineIsNotDrawnAgain) {
  const mapping::PolygonMap map(room().room_m());
  localization::ContactModel model(map, create_robot().body.radius_m);
  localization::MonteCarloLocalizer localizer(model, create_params_of({}), std::mt19937(1));
  localizer.update({}, {});
  localizer.start_at({2.5, 1.2, 0.0}, 0.6, 1.0);
  EXPECT_GT(outside_share(localizer.particles()), 0.3);
  localizer.update({}, {});
  EXPECT_EQ(outside_share(localizer.particles()), 0.0);
}

}  // namespace
}  // namespace echomap::papers
