// SPDX-License-Identifier: MIT
#include "host/papers/epuck_localization.hpp"

#include <algorithm>
#include <random>

#include "hil_mock/world/noise.hpp"
#include "host/localization/correlation_model.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/localization/polygon_view.hpp"
#include "host/localization/resampling.hpp"
#include "host/localization/view_model.hpp"
#include "host/models/infrared_range.hpp"
#include "host/papers/epuck_field.hpp"
#include "host/papers/epuck_ring.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr std::size_t kIterations = 400;
constexpr double kConvergedM = 0.04;
constexpr double kRightM = 0.03;
/// Standard deviations of the wheels' errors, as a share of the motion and in each step.
constexpr double kOdometryShare = 0.03;
constexpr double kOdometryTurnRad = 0.002;

localization::CorrelationModelParams correlation_params() {
  localization::CorrelationModelParams params;
  params.cell_m = 0.006;
  params.sector.thickness_m = 0.012;
  params.sector.max_range_m = kEpuckReachM;
  params.sector.beam_width_rad = EpuckGridParams{}.beam_width_rad;
  return params;
}

localization::LocalizerParams filter_params(const EpuckTrial& trial) {
  auto params = localization::localizer_params(localization::LocalizerPreset::kEpuck, {});
  params.filter.resampling_share = trial.resampling_share;
  params.filter.likelihood_exponent = trial.likelihood_exponent;
  return params;
}

Cluster cluster_of(const localization::Particles& particles) {
  std::vector<float> weights;
  localization::relative_weights(particles, weights, localization::Workers());
  Cluster cluster;
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto weight = static_cast<double>(weights[i]);
    const Eigen::Vector2d at_m = particles.pose(i).position_m();
    sum += weight;
    cluster.mean_m += weight * at_m;
    cluster.covariance_m2 += weight * at_m * at_m.transpose();
  }
  cluster.mean_m /= sum;
  cluster.covariance_m2 /= sum;
  cluster.covariance_m2 -= cluster.mean_m * cluster.mean_m.transpose();
  cluster.covariance_m2.diagonal() = cluster.covariance_m2.diagonal().cwiseMax(0.0);
  return cluster;
}

/// The odometry's step for a true one.
Pose2 measured_step(const Pose2& T_last_now, world::NoiseStream& noise) {
  const double turn_scale = 1.0 + kOdometryShare * noise.normal();
  const double turn_error_rad = kOdometryTurnRad * noise.normal();
  const double drive_scale = 1.0 + kOdometryShare * noise.normal();
  return {T_last_now.x_m() * drive_scale,
          T_last_now.y_m(),
          T_last_now.heading_rad() * turn_scale + turn_error_rad};
}

bool is_shown(const EpuckTrial& trial, std::size_t iteration) {
  return std::ranges::find(trial.shown_iterations, iteration) != trial.shown_iterations.end();
}

/// Steps at the end of a run that belong to one cluster.
std::size_t converged_steps(const EpuckRun& run) {
  const auto is_wide = [](const ClusterStep& step) {
    return step.cluster.stddev_m().norm() >= kConvergedM;
  };
  const auto last_wide = std::find_if(run.steps.rbegin(), run.steps.rend(), is_wide);
  return static_cast<std::size_t>(last_wide - run.steps.rbegin());
}

}  // namespace

std::unique_ptr<localization::ObservationModel> correlation_with(const mapping::RasterMap& grid) {
  return std::make_unique<localization::CorrelationModel>(grid, correlation_params());
}

std::unique_ptr<localization::ObservationModel> light_from_true_walls() {
  const mapping::PolygonMap walls(epuck_field().room_m(), epuck_field().obstacles_m());
  return std::make_unique<
      localization::ViewModel<localization::PolygonView, models::InfraredRange>>(
      localization::rasterize(walls, 0.01),
      localization::PolygonView(walls),
      models::InfraredRange());
}

EpuckRun localize_epuck(localization::ObservationModel& model,
                        const EpuckTrial& trial,
                        double start,
                        std::uint32_t seed) {
  localization::MonteCarloLocalizer localizer(model, filter_params(trial), std::mt19937(seed));
  EpuckRing ring(epuck_field(), seed);
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  const std::vector<Pose2> lap = epuck_lap({.length_m = 0.03, .turn_rad = 0.5}, noise.uniform());
  auto at = static_cast<std::size_t>(start * static_cast<double>(lap.size()));
  Pose2 T_odom_robot;
  EpuckRun run;
  for (std::size_t iteration = 1; iteration <= kIterations; ++iteration) {
    localizer.update(T_odom_robot, ring.read(lap[at]));
    run.steps.push_back({cluster_of(localizer.particles()), lap[at]});
    if (is_shown(trial, iteration)) {
      run.shown.push_back({iteration, positions_of(localizer.particles())});
    }
    const std::size_t next = (at + 1) % lap.size();
    T_odom_robot = T_odom_robot * measured_step(lap[at].inverse() * lap[next], noise);
    at = next;
  }
  return run;
}

EpuckScore score_of(const EpuckRun& run) {
  EpuckScore score;
  score.is_right = run.steps.back().error_m().norm() < kRightM;
  const std::size_t count = converged_steps(run);
  if (count == 0) {
    return score;
  }
  const std::size_t first = run.steps.size() - count;
  score.converged_at = first + 1;
  for (std::size_t i = first; i < run.steps.size(); ++i) {
    const Eigen::Vector2d error_m = run.steps[i].error_m();
    const Eigen::Array2d bounds_m = 3.0 * run.steps[i].cluster.stddev_m().array();
    score.beyond_share +=
        static_cast<double>((error_m.cwiseAbs().array() > bounds_m).count()) / 2.0;
    score.mean_error_m += error_m.norm();
  }
  score.beyond_share /= static_cast<double>(count);
  score.mean_error_m /= static_cast<double>(count);
  return score;
}

}  // namespace echomap::papers
