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

/// What the localizer says of itself.
enum class LocalizationStatus : std::uint8_t {
  kLost,        ///< The robot is not where it was thought to be: what was known has been given up.
  kRecovering,  ///< There is more than one place, or one too wide to be called one.
  kLocalized,
};

/// Where the robot may be.
struct PoseBelief {
  LocalizationStatus status = LocalizationStatus::kRecovering;
  /// That the robot is not at the first hypothesis.
  double lost_probability = 1.0;
  /// The likeliest first; empty where there is no floor to stand on.
  std::vector<PoseHypothesis> hypotheses;
  /// Of the last update.
  LocalizerOutcome outcome = LocalizerOutcome::kNoParticles;
};

/// What a robot that may be anywhere begins with.
enum class GlobalStart : std::uint8_t {
  kLattice,    ///< The first sweep weighs a lattice of poses, and particles are drawn from that.
  kScattered,  ///< As many particles as there are at most, anywhere on the floor.
};

/// Settings of a MonteCarloLocalizer, chosen on simulated rooms and on the building of
/// docs/algorithms/localization.md.
struct LocalizerParams {
  ParticleFilterParams filter;
  models::MotionModel motion;
  LossMonitorParams loss;
  /// Otherwise a robot that was carried off has to be told so.
  bool watches_for_loss = true;
  GlobalStart global_start = GlobalStart::kLattice;
  /// A robot that may be anywhere is looked for at places and headings so far apart.
  double lattice_m = 0.2;
  double lattice_rad = 0.1963495;  ///< 11.25 degrees.
  /// A suspicion that has not proved right after so many sweeps is dropped, or raised anew.
  int suspicious_sweeps = 6;
  /// The robot is lost above this probability.
  double lost_above = 0.5;
  /// And localized below this one, where the first hypothesis is also narrower than that.
  double localized_below = 0.1;
  double localized_std_m = 0.25;
  /// Particles follow the odometry when there are readings, and without any in steps of that: how
  /// far it may be off does not depend on how often it speaks. In between the belief is carried
  /// along.
  double step_m = 0.1;
  double step_rad = 0.1745;  ///< 10 degrees.
  /// Threads that share the work; the belief is the same for any number.
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
  /// for settings without sense. The model must outlive this; the generator is the caller's seed.
  MonteCarloLocalizer(ObservationModel& model, const LocalizerParams& params, std::mt19937 random);

  /// The robot is about there, with standard deviations of place and heading, where its odometry is
  /// what the last update said. Answers kMoved, or why it did not start there: kNotFinite,
  /// kOffTheFloor, kUnknownMap or kNoFloor.
  LocalizerOutcome start_at(const geometry::Pose2& T_map_robot, double std_m, double std_rad);
  /// The robot may be anywhere from now on: it was carried off.
  void start_anywhere();

  /// Where the robot is after a step of its odometry and a sweep of readings, of which there may be
  /// none.
  const PoseBelief& update(const geometry::Pose2& T_odom_robot,
                           std::span<const RangeReading> readings);

  const PoseBelief& belief() const { return belief_; }
  /// As of the last readings or step.
  const Particles& particles() const { return here_.particles(); }

 private:
  void follow(const geometry::Pose2& T_odom_robot);
  /// Moves the belief alone.
  void carry(const geometry::Pose2& T_odom_robot);
  bool has_made_a_step(const geometry::Pose2& T_odom_robot) const;
  bool is_on_floor(const Particles& particles) const;
  LocalizerOutcome outcome_of(std::span<const RangeReading> readings) const;
  void weigh_readings();
  void judge(double log_here);
  /// Starts a filter from the whole floor; returns the logarithm of the readings' mean likelihood.
  double look_everywhere(ParticleFilter& filter);
  void believe();
  void judge_status();

  ObservationModel& model_;
  LocalizerParams params_;
  Workers workers_;
  Particles lattice_;         ///< Made when it is first needed.
  ParticleFilter here_;       ///< Empty while nothing is known.
  ParticleFilter elsewhere_;  ///< Empty while there is no suspicion.
  int sweeps_elsewhere_ = 0;
  bool gave_up_ = false;  ///< At this update.
  bool was_off_floor_ = false;
  /// Without a floor there is nowhere to be.
  std::optional<LocalizerOutcome> nowhere_;
  LossMonitor loss_;
  std::mt19937 random_;                            ///< Of starts anywhere.
  std::optional<geometry::Pose2> T_odom_last_;     ///< Of the particles.
  std::optional<geometry::Pose2> T_odom_carried_;  ///< Of the belief.
  PoseBelief belief_;
};

}  // namespace echomap::localization
