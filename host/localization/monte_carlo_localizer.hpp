// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "host/localization/localizer_outcome.hpp"
#include "host/localization/loss_monitor.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/particle_filter.hpp"
#include "host/localization/pose_hypotheses.hpp"
#include "host/models/motion_model.hpp"

namespace echomap::localization {

/// Status of the localizer.
enum class LocalizationStatus : std::uint8_t {
  kLost,        ///< The readings contradict the pose: the estimate was discarded.
  kRecovering,  ///< There are several pose hypotheses, or one that is too wide.
  kLocalized,
};

/// Where the robot may be.
struct PoseBelief {
  LocalizationStatus status = LocalizationStatus::kRecovering;
  /// Probability that the robot is not at the first hypothesis.
  double lost_probability = 1.0;
  /// Pose hypotheses, the most likely first; empty where the map has no floor.
  std::vector<PoseHypothesis> hypotheses;
  /// Outcome of the last update.
  LocalizerOutcome outcome = LocalizerOutcome::kNoParticles;
};

/// How global localization is initialized.
enum class GlobalStart : std::uint8_t {
  kLattice,    ///< The first sweep weights a lattice of poses from which particles are sampled.
  kScattered,  ///< max_particles particles, uniformly over the floor.
};

/// Settings of a MonteCarloLocalizer, chosen on simulated rooms and on the building of
/// docs/algorithms/localization.md.
struct LocalizerParams {
  ParticleFilterParams filter;
  models::MotionModel motion;
  LossMonitorParams loss;
  /// Detects a kidnapped robot; without it start_anywhere() has to be called.
  bool watches_for_loss = true;
  GlobalStart global_start = GlobalStart::kLattice;
  /// Spacing of the lattice of poses for global localization.
  double lattice_m = 0.2;
  double lattice_rad = 0.1963495;  ///< 11.25 degrees.
  /// A suspicion that is not confirmed within this many sweeps is dropped or raised again.
  int suspicious_sweeps = 6;
  /// The status is kLost above this probability of being lost.
  double lost_above = 0.5;
  /// The status is kLocalized below this probability, if the first hypothesis is narrower than
  /// localized_stddev_m.
  double localized_below = 0.1;
  double localized_stddev_m = 0.25;
  /// Particles follow the odometry when there are readings, and without any in steps of that: how
  /// far it may be off does not depend on how often it speaks. In between the belief is carried
  /// along.
  double step_m = 0.1;
  double step_rad = 0.1745;  ///< 10 degrees.
  /// Number of worker threads; the belief does not depend on it.
  int threads = 1;
  HypothesisParams hypotheses;
};

/// Monte-Carlo localization (Dellaert et al. 1999) that looks for a robot everywhere at once when
/// it does not know: a sweep of readings weighs a lattice of all
/// poses, and particles are drawn from that. When the readings of a robot that was localized become
/// unlikely, a second filter looks everywhere and follows beside the first. Their evidence decides,
/// by Bayes' rule, how much of the first is given up for the second.
class MonteCarloLocalizer {
 public:
  /// The robot may be anywhere on the free cells of the model's map. Throws std::invalid_argument
  /// for invalid settings. The model must outlive this; the generator is the caller's seed.
  MonteCarloLocalizer(ObservationModel& model, const LocalizerParams& params, std::mt19937 random);

  /// The robot is about there, with standard deviations of place and heading, where its odometry is
  /// what the last update said. Answers kMoved, or why it did not start there: kNotFinite,
  /// kOffTheFloor, kUnknownMap or kNoFloor.
  LocalizerOutcome start_at(const geometry::Pose2& T_map_robot, double stddev_m, double stddev_rad);
  /// Restarts global localization, as after the robot was carried off.
  void start_anywhere();

  /// Where the robot is after a step of its odometry and a sweep of readings, of which there may be
  /// none.
  const PoseBelief& update(const geometry::Pose2& T_odom_robot,
                           std::span<const RangeReading> readings);

  const PoseBelief& belief() const { return belief_; }
  /// Particles as of the last readings or step.
  const Particles& particles() const { return here_.particles(); }

 private:
  void follow(const geometry::Pose2& T_odom_robot);
  /// Moves the belief by odometry, without updating the particles.
  void carry(const geometry::Pose2& T_odom_robot);
  bool has_made_a_step(const geometry::Pose2& T_odom_robot) const;
  bool is_on_floor(const Particles& particles) const;
  LocalizerOutcome outcome_of(std::span<const RangeReading> readings) const;
  void update_weights();
  void update_loss_probability(double log_here);
  /// Initializes a filter over the whole floor; returns the logarithm of the readings' mean
  /// likelihood.
  double look_everywhere(ParticleFilter& filter);
  void estimate();
  void classify_status();

  ObservationModel& model_;
  LocalizerParams params_;
  Workers workers_;
  Particles lattice_;    ///< Made on first use.
  ParticleFilter here_;  ///< Filter of the current hypothesis; empty until initialized.
  ParticleFilter
      elsewhere_;  ///< Filter over the whole floor while the robot may be lost; else empty.
  int sweeps_elsewhere_ = 0;
  bool gave_up_ = false;  ///< Whether this update discarded the estimate.
  bool was_off_floor_ = false;
  /// Set where the map has no floor to localize on.
  std::optional<LocalizerOutcome> nowhere_;
  LossMonitor loss_;
  std::mt19937 random_;                            ///< Generator of global starts.
  std::optional<geometry::Pose2> T_odom_last_;     ///< Odometry pose at which the particles are.
  std::optional<geometry::Pose2> T_odom_carried_;  ///< Odometry pose at which the belief is.
  PoseBelief belief_;
};

}  // namespace echomap::localization
