// SPDX-License-Identifier: MIT
#include "host/papers/contact_localization.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "host/geometry/angle.hpp"
#include "host/localization/contact_model.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/papers/bounce_drive.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr int kObservations = 70;
constexpr int kBumps = 25;
constexpr double kStepM = 0.15;

localization::LocalizerParams params_of(const ContactTrial& trial) {
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

double outside_share(const std::vector<Eigen::Vector2d>& positions_m) {
  double outside = 0.0;
  for (const Eigen::Vector2d& position_m : positions_m) {
    outside += contact_room().is_free(position_m) ? 0.0 : 1.0;
  }
  return outside / static_cast<double>(positions_m.size());
}

}  // namespace

const world::FloorPlan& contact_room() {
  static const world::FloorPlan plan(
      "outline",
      {{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.6}, {2.2, 1.6}, {1.7, 2.6}, {0.0, 2.6}}, {}},
      {},
      Pose2(1.0, 1.0, 0.0));
  return plan;
}

ContactOutcome localize_by_contacts(const ContactTrial& trial, std::uint32_t seed) {
  const mapping::PolygonMap map(contact_room().room_m());
  localization::ContactModel model(map, create_robot().body.radius_m);
  localization::MonteCarloLocalizer localizer(model, params_of(trial), std::mt19937(seed));
  BounceRobot robot(contact_room(), seed);
  ContactOutcome outcome;
  while (robot.bumps() < kBumps) {
    robot.step(kStepM);
    model.add_contact(robot.contacts());
    localizer.update(robot.T_odom_robot(), {});
    if (outcome.first_particles_m.empty()) {
      outcome.first_particles_m = positions_of(localizer.particles());
    }
  }
  const Pose2& found = localizer.belief().hypotheses.at(0).T_map_robot;
  outcome.T_world_robot = robot.T_world_robot();
  outcome.error_m = (found.position_m() - outcome.T_world_robot.position_m()).norm();
  outcome.heading_error_rad =
      std::abs(geometry::angle_between(found.heading_rad(), outcome.T_world_robot.heading_rad()));
  outcome.last_particles_m = positions_of(localizer.particles());
  outcome.outside_share = outside_share(outcome.last_particles_m);
  return outcome;
}

models::LinearOdometryMotionParams mean_odometry_errors(std::uint32_t seed) {
  const world::RobotParams robot = create_robot();
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  constexpr double kDriveM = 0.36;
  constexpr double kTurnRad = 2.0 * std::numbers::pi;
  models::LinearOdometryMotionParams alphas{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < kObservations; ++i) {
    WheelErrors errors(robot.drive, noise);
    const Pose2 drive = errors.measured(0.0, kDriveM);
    const Pose2 turn = errors.measured(kTurnRad, 0.0);
    alphas.alpha1_rad_per_m += std::abs(drive.heading_rad()) / kDriveM / kObservations;
    alphas.alpha2 += std::abs(turn.heading_rad()) / kTurnRad / kObservations;
    alphas.alpha3 += std::abs(drive.x_m() - kDriveM) / kDriveM / kObservations;
    alphas.alpha4_m_per_rad += turn.position_m().norm() / kTurnRad / kObservations;
  }
  return alphas;
}

double mean_error_scale() { return 3.0 / std::sqrt(2.0 / std::numbers::pi); }

}  // namespace echomap::papers
