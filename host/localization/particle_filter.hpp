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
  std::size_t least_particles = 1500;
  std::size_t most_particles = 20000;
  /// Share of a reading's logarithm that counts, and how many readings a sweep counts for at most
  /// when they are shared so: those of one sweep err together, the more the closer they lie.
  double temper = 0.4;
  double most_independent = 6.0;
  /// Particles are drawn anew when fewer than this share of them count (Mahmood and Ridao 2017).
  double resampling_share = 0.5;
  ResamplingScheme scheme = ResamplingScheme::kSystematic;
  /// Greatest error of the sample, for its size (Fox 2003), in bins of 20 cm and 10 degrees.
  double sample_error = 0.025;
  NoiseShape motion_noise = NoiseShape::kNormal;
  /// What is drawn is spread by so much, so that no two particles stay alike.
  double spread_m = 0.03;
  double spread_rad = 0.015;
};

/// Particles of a robot in a map (Thrun, Burgard and Fox 2005, table 8.2), as many as their spread
/// needs. Without any it is anywhere.
class ParticleFilter {
 public:
  /// Throws std::invalid_argument for settings without sense. The generator is the caller's seed;
  /// results are the same for any number of workers.
  ParticleFilter(const ParticleFilterParams& params,
                 std::mt19937 random,
                 Workers workers = Workers());

  const Particles& particles() const { return particles_; }
  /// Of the particles, relative to the greatest.
  std::span<const float> weights() const { return weights_; }
  bool empty() const { return particles_.size() == 0; }
  void clear();

  /// Around a pose, with standard deviations of place and heading.
  void start_at(const geometry::Pose2& T_map_robot, double std_m, double std_rad);
  /// Takes these particles, which have equal weights.
  void start_with(Particles particles);
  /// Draws particles from weighed poses, each spread by so much; returns the logarithm of the sum
  /// of those poses' weights, 0 for none.
  double start_from(const Particles& weighed, double std_m, double std_rad);

  void move(const models::OdometryStep& step, const models::MotionSpread& spread);
  /// The share of a sweep's logarithm that counts.
  double temper(const ObservationModel& model) const;
  /// Weighs the particles by the sweep that a model observed; returns the logarithm of their mean
  /// likelihood, tempered, and 0 for no particles.
  double weigh(ObservationModel& model);
  /// The number only falls: docs/algorithms/localization.md, step 4.
  void resample_where_few_count();
  /// Takes in the particles of another filter so that they have `share` of all weight.
  void join(const ParticleFilter& other, double share);

 private:
  void take_equal_weights();
  void draw(const Particles& from, std::size_t count);
  std::size_t wanted_count() const;
  void scatter(double std_m, double std_rad);

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
