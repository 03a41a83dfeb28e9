// SPDX-License-Identifier: MIT
// Mahmood and Ridao 2017, section 4.1, Monte-Carlo localization: 1,000
// particles in the grid that the e-puck has made of its field, weighed by correlation, resampled at
// every step or only when fewer than half of them count. A step is 3 cm or 30 degrees; the paper
// does not say what it is.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/world/noise.hpp"
#include "host/localization/correlation_model.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/localization/polygon_view.hpp"
#include "host/localization/resampling.hpp"
#include "host/localization/view_model.hpp"
#include "host/models/infrared_range.hpp"
#include "tests/papers/epuck_field.hpp"
#include "tests/papers/epuck_ring.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

constexpr int kMclRuns = 12;
constexpr int kSteps = 400;
constexpr double kConvergedM = 0.04;
constexpr double kEveryStep = 1.0;
constexpr double kNeff = 0.5;

localization::CorrelationModelParams model_params() {
  localization::CorrelationModelParams params;
  params.cell_m = 0.006;
  params.sector.thickness_m = 0.012;
  params.sector.max_range_m = 0.06;
  params.sector.beam_width_rad = 0.1745;
  return params;
}

/// Mean and deviation of all particles, as the paper's ellipse.
struct Cluster {
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d stddev_m = Eigen::Vector2d::Zero();
};

Cluster cluster_of(const localization::Particles& particles) {
  std::vector<float> weights;
  localization::relative_weights(particles, weights, localization::Workers());
  Cluster cluster;
  double sum = 0.0;
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto weight = static_cast<double>(weights[i]);
    const Eigen::Vector2d at_m = particles.pose(i).position_m();
    sum += weight;
    cluster.mean_m += weight * at_m;
    squares += weight * at_m.cwiseAbs2();
  }
  cluster.mean_m /= sum;
  cluster.stddev_m = (squares / sum - cluster.mean_m.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return cluster;
}

/// A step of a run.
struct Moment {
  Cluster cluster;
  Eigen::Vector2d error_m = Eigen::Vector2d::Zero();
};

using MakeModel = std::unique_ptr<localization::ObservationModel> (*)();

/// The paper's: correlation with the grid that the e-puck has made.
std::unique_ptr<localization::ObservationModel> correlation() {
  static const mapping::RasterMap grid = map_epuck_field(epuck_field(), {}, 1);
  return std::make_unique<localization::CorrelationModel>(grid, model_params());
}

/// Ours: the light of each sensor, in the field's true walls.
std::unique_ptr<localization::ObservationModel> infrared() {
  const mapping::PolygonMap walls(epuck_field().room_m(), epuck_field().obstacles_m());
  return std::make_unique<
      localization::ViewModel<localization::PolygonView, models::InfraredRange>>(
      localization::rasterize(walls, 0.01),
      localization::PolygonView(walls),
      models::InfraredRange());
}

/// How a filter is put together.
struct MclTrial {
  double resampling_share = kEveryStep;
  MakeModel make_model = correlation;
  double likelihood_exponent = 1.0;
};

/// An e-puck on a lap of its field, from place `start` of the lap on, 0 to 1.
std::vector<Moment> follow(std::uint32_t seed, double start, const MclTrial& trial) {
  const auto model = trial.make_model();
  auto params = localization::localizer_params(localization::LocalizerPreset::kEpuck, {});
  params.filter.resampling_share = trial.resampling_share;
  params.filter.likelihood_exponent = trial.likelihood_exponent;
  localization::MonteCarloLocalizer localizer(*model, params, std::mt19937(seed));
  EpuckRing ring(epuck_field(), seed);
  world::NoiseStream noise(seed, world::NoisePurpose::kBody);
  const std::vector<Pose2> lap = epuck_lap({.length_m = 0.03, .turn_rad = 0.5}, noise.uniform());
  auto at = static_cast<std::size_t>(start * static_cast<double>(lap.size()));
  Pose2 T_odom_robot;
  std::vector<Moment> moments;
  for (int step = 0; step < kSteps; ++step) {
    localizer.update(T_odom_robot, ring.read(lap[at]));
    const Cluster cluster = cluster_of(localizer.particles());
    moments.push_back({cluster, cluster.mean_m - lap[at].position_m()});
    const std::size_t next = (at + 1) % lap.size();
    const Pose2 moved = lap[at].inverse() * lap[next];
    T_odom_robot = T_odom_robot * Pose2(moved.x_m() * (1.0 + 0.03 * noise.normal()),
                                        moved.y_m(),
                                        moved.heading_rad() * (1.0 + 0.03 * noise.normal()) +
                                            0.002 * noise.normal());
    at = next;
  }
  return moments;
}

/// The step from which on all particles are one cluster.
std::size_t converged_at(const std::vector<Moment>& moments) {
  std::size_t since = moments.size();
  while (since > 0 && moments[since - 1].cluster.stddev_m.norm() < kConvergedM) {
    --since;
  }
  return since;
}

/// Of `kMclRuns`.
struct MclRates {
  int right = 0;      ///< In the end within 3 cm.
  int converged = 0;  ///< To one cluster, wherever it is.
  double mean_converged_at = 0.0;
  /// Of those that are right, since they converged.
  double outside_share = 0.0;  ///< Errors in x or y of more than 3 sigma.
  double mean_error_m = 0.0;
};

void add(const std::vector<Moment>& moments, std::size_t since, MclRates& rates, double& judged) {
  for (std::size_t i = since; i < moments.size(); ++i) {
    const auto bound_m = 3.0 * moments[i].cluster.stddev_m.array();
    rates.outside_share +=
        static_cast<double>((moments[i].error_m.cwiseAbs().array() > bound_m).count()) / 2.0;
    rates.mean_error_m += moments[i].error_m.norm();
    judged += 1.0;
  }
}

MclRates mcl_rates_of(const std::string& name, const MclTrial& trial) {
  MclRates rates;
  double judged = 0.0;
  for (int run = 1; run <= kMclRuns; ++run) {
    const auto moments =
        follow(static_cast<std::uint32_t>(run), static_cast<double>(run) / (kMclRuns + 1), trial);
    const std::size_t since = converged_at(moments);
    if (since < moments.size()) {
      ++rates.converged;
      rates.mean_converged_at += static_cast<double>(since);
    }
    if (moments.back().error_m.norm() < 0.03) {
      ++rates.right;
      add(moments, since, rates, judged);
    }
  }
  rates.mean_converged_at /= rates.converged;
  rates.outside_share /= judged;
  rates.mean_error_m /= judged;
  std::cout << name << ": right " << rates.right << ", converged " << rates.converged << " of "
            << kMclRuns << ", at step " << rates.mean_converged_at << ", beyond 3 sigma "
            << rates.outside_share << ", mean error " << rates.mean_error_m << " m\n";
  return rates;
}

TEST(Paper002Localization, ErrorsStayWithinThreeSigmaWithAndWithoutNeff) {
  const MclRates every_step = mcl_rates_of("drawn at every step", {});
  const MclRates neff =
      mcl_rates_of("drawn where fewer than half count", {.resampling_share = kNeff});
  for (const MclRates& rates : {every_step, neff}) {
    EXPECT_GE(rates.right, kMclRuns / 3);
    EXPECT_LT(rates.outside_share, 0.01);
    EXPECT_LT(rates.mean_error_m, 0.02);
  }
  // That Neff converges later, as the paper has it, is not so here: the page has 80 runs of it.
  EXPECT_GE(neff.right, every_step.right - 3);
}

TEST(Paper002Localization, AModelOfTheLightIsSureSoonerButNotMoreOftenRight) {
  const MclRates light = mcl_rates_of(
      "a model of the light, tempered by 0.15",
      {.resampling_share = kNeff, .make_model = infrared, .likelihood_exponent = 0.15});
  EXPECT_GE(light.right, kMclRuns / 4);
  EXPECT_LT(light.outside_share, 0.03);
  EXPECT_LT(light.mean_converged_at, 140.0);
}

}  // namespace
}  // namespace echomap::papers
