// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::papers {

/// Settings of the particle filter of Mahmood and Ridao 2017, section 4.1, with 1,000 particles.
struct EpuckTrial {
  /// Resampled below this share of the effective sample size, Neff: 1 is at every step, 0.5 the
  /// paper's threshold of M / 2.
  double resampling_share = 1.0;
  double likelihood_exponent = 1.0;
  /// Iterations, from 1, whose particles are kept.
  std::vector<std::size_t> shown_iterations{};
};

/// Position of all particles as one cluster, as the paper's ellipse; world frame.
struct Cluster {
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();

  /// In x and y.
  Eigen::Vector2d stddev_m() const { return covariance_m2.diagonal().cwiseSqrt(); }
};

/// One iteration of the filter.
struct ClusterStep {
  Cluster cluster;
  geometry::Pose2 T_world_robot;  ///< In truth.

  /// Error of the cluster's mean in x and y.
  Eigen::Vector2d error_m() const { return cluster.mean_m - T_world_robot.position_m(); }
};

/// The particles of one iteration.
struct ShownParticles {
  std::size_t iteration = 0;
  std::vector<Eigen::Vector2d> particles_m;  ///< World frame.
};

/// One run of the filter.
struct EpuckRun {
  std::vector<ClusterStep> steps;
  std::vector<ShownParticles> shown;
};

/// The paper's measurement model: a local map of cells of 6 mm correlated with the grid that the
/// e-puck has made of its field, in the world frame.
std::unique_ptr<localization::ObservationModel> correlation_with(const mapping::RasterMap& grid);

/// Our measurement model: the light that each sensor gets back from the field's true walls.
std::unique_ptr<localization::ObservationModel> light_from_true_walls();

/// Localizes a simulated e-puck in `epuck_field` from nowhere, in 400 steps of 3 cm or 0.5 rad; it
/// starts at share `start`, 0 to 1, of `epuck_lap`.
EpuckRun localize_epuck(localization::ObservationModel& model,
                        const EpuckTrial& trial,
                        double start,
                        std::uint32_t seed);

/// What becomes of one run.
struct EpuckScore {
  bool is_right = false;                    ///< The mean is within 3 cm of the robot at the end.
  std::optional<std::size_t> converged_at;  ///< Iteration, from 1, from which on all particles
                                            ///< are one cluster of 4 cm, wherever it is.
  /// Since it converged: share of the errors in x or y beyond 3 sigma, and the mean error.
  double beyond_share = 0.0;
  double mean_error_m = 0.0;
};

/// Scores a run.
EpuckScore score_of(const EpuckRun& run);

}  // namespace echomap::papers
