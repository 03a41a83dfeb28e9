// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "host/localization/motion_update.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/resampling.hpp"
#include "host/localization/workers.hpp"
#include "host/models/odometry_motion.hpp"

namespace echomap::localization {

/// Settings of a ParticleFilter, ours unless a source is named.
struct ParticleFilterParams {
  std::size_t min_particles = 1500;
  std::size_t max_particles = 20000;
  /// Exponent on the likelihood of a reading, and the largest number of independent readings that
  /// one sweep counts as: readings of one sweep have correlated errors, the more so the closer they
  /// lie.
  double likelihood_exponent = 0.4;
  double max_independent = 6.0;
  /// Particles are resampled when fewer than this share of them count (Mahmood and Ridao 2017).
  double resampling_share = 0.5;
  ResamplingScheme scheme = ResamplingScheme::kSystematic;
  /// Maximum sampling error, which sets the number of particles (KLD-sampling, Fox 2003), in bins
  /// of 20 cm and 10 degrees.
  double sample_error = 0.025;
  NoiseShape motion_noise = NoiseShape::kNormal;
  /// Standard deviations of the noise added to resampled particles, so that no two stay alike.
  double spread_m = 0.03;
  double spread_rad = 0.015;
};

/// Particles of a robot in a map (Thrun, Burgard and Fox 2005, table 8.2), as many as their spread
/// needs. Without any it is anywhere.
class ParticleFilter {
 public:
  /// Throws std::invalid_argument for invalid settings. The generator is the caller's seed; results
  /// are the same for any number of workers.
  ParticleFilter(const ParticleFilterParams& params,
                 std::mt19937 random,
                 Workers workers = Workers());

  const Particles& particles() const { return particles_; }
  /// Weights of the particles, relative to the greatest.
  std::span<const float> weights() const { return weights_; }
  bool empty() const { return particles_.size() == 0; }
  void clear();

  /// Samples particles around a pose, with standard deviations of position and heading.
  void start_at(const geometry::Pose2& T_map_robot, double stddev_m, double stddev_rad);
  /// Starts with these particles, at equal weights.
  void start_with(Particles particles);
  /// Draws particles from weighed poses, each spread by so much; returns the logarithm of the sum
  /// of those poses' weights, 0 for none.
  double start_from(const Particles& weighted, double stddev_m, double stddev_rad);

  void move(const models::OdometryStep& step, const models::MotionSpread& spread);
  /// The exponent on a sweep's likelihood.
  double likelihood_exponent(const ObservationModel& model) const;
  /// Updates the weights with the sweep that a model observed; returns the logarithm of the
  /// particles' mean likelihood with the exponent applied, 0 without particles.
  double update_weights(ObservationModel& model);
  /// Resamples if the effective sample size is low; the number of particles only falls
  /// (docs/algorithms/localization.md, step 4).
  void resample_if_needed();
  /// Adds the particles of another filter with `share` of the total weight.
  void join(const ParticleFilter& other, double share);

 private:
  void equalize_weights();
  void draw(const Particles& from, std::size_t count);
  std::size_t wanted_count() const;
  void scatter(double stddev_m, double stddev_rad);

  ParticleFilterParams params_;
  std::mt19937 random_;
  Workers workers_;
  Particles particles_;
  Particles spare_;
  std::vector<float> weights_;
  WeightSums sums_;  ///< Of the weights.
  std::vector<std::uint32_t> ancestors_;
};

}  // namespace echomap::localization
