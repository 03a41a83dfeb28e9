// SPDX-License-Identifier: MIT
#include "host/localization/monte_carlo_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/geometry/parameter_validator.hpp"
#include "host/localization/floor_lattice.hpp"
#include "host/localization/scattered_particles.hpp"
#include "host/localization/usable_reading.hpp"

namespace echomap::localization {

namespace {

bool is_probability(double value) { return value >= 0.0 && value <= 1.0; }

const LocalizerParams& validated(const LocalizerParams& params) {
  geometry::ParameterValidator("localizer")
      .positive("lattice_m", params.lattice_m)
      .positive("lattice_rad", params.lattice_rad)
      .positive("step_m", params.step_m)
      .positive("step_rad", params.step_rad)
      .at_least("suspicious_sweeps", params.suspicious_sweeps, 1);
  const HypothesisParams& bins = params.hypotheses;
  geometry::ParameterValidator("localizer")
      .positive("bins.bin_m", bins.bin_m)
      .positive("bins.bin_rad", bins.bin_rad)
      .at_most("bins.bin_rad", bins.bin_rad, 2.0 * std::numbers::pi);
  if (!is_probability(params.lost_above) || !is_probability(params.localized_below) ||
      !(params.localized_stddev_m > 0.0)) {
    throw std::invalid_argument(
        "localizer: what is lost or localized is by probabilities and a deviation above 0");
  }
  return params;
}

/// Another generator than one with the same seed.
std::mt19937 branch_of(std::mt19937 random) {
  return std::mt19937(static_cast<std::uint32_t>(random()));
}

/// Why a robot can be nowhere in a map.
std::optional<LocalizerOutcome> nowhere_in(const mapping::RasterMap& map) {
  auto why = LocalizerOutcome::kUnknownMap;
  for (std::int32_t y = 0; y < map.rows(); ++y) {
    for (std::int32_t x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == mapping::CellState::kFree) {
        return std::nullopt;
      }
      if (map.state({x, y}) == mapping::CellState::kOccupied) {
        why = LocalizerOutcome::kNoFloor;
      }
    }
  }
  return why;
}

}  // namespace

MonteCarloLocalizer::MonteCarloLocalizer(ObservationModel& model,
                                         const LocalizerParams& params,
                                         std::mt19937 random)
    : model_(model),
      params_(validated(params)),
      workers_(params.threads),
      here_(params.filter, random, workers_),
      elsewhere_(params.filter, branch_of(random), workers_),
      nowhere_(nowhere_in(model.map())),
      loss_(params.loss),
      random_(branch_of(branch_of(random))) {}

LocalizerOutcome MonteCarloLocalizer::start_at(const geometry::Pose2& T_map_robot,
                                               double stddev_m,
                                               double stddev_rad) {
  if (nowhere_) {
    return *nowhere_;
  }
  if (!is_finite(T_map_robot) || !std::isfinite(stddev_m) || !std::isfinite(stddev_rad)) {
    return LocalizerOutcome::kNotFinite;
  }
  gave_up_ = false;
  here_.start_at(T_map_robot, stddev_m, stddev_rad);
  T_odom_last_ = T_odom_carried_;
  elsewhere_.clear();
  loss_.restart();
  const bool is_there = is_on_floor(here_.particles());
  if (!is_there) {
    here_.clear();
  }
  estimate();
  return is_there ? LocalizerOutcome::kMoved : LocalizerOutcome::kOffTheFloor;
}

void MonteCarloLocalizer::start_anywhere() {
  gave_up_ = false;
  here_.clear();
  elsewhere_.clear();
  loss_.restart();
  estimate();
}

const PoseBelief& MonteCarloLocalizer::update(const geometry::Pose2& T_odom_robot,
                                              std::span<const RangeReading> readings) {
  if (!is_finite(T_odom_robot)) {
    belief_.outcome = LocalizerOutcome::kNotFinite;
    return belief_;
  }
  gave_up_ = false;
  was_off_floor_ = false;
  model_.observe(readings);
  if (model_.count() > 0) {
    follow(T_odom_robot);
    update_weights();
    here_.resample_if_needed();
    elsewhere_.resample_if_needed();
    estimate();
  } else if (has_made_a_step(T_odom_robot)) {
    follow(T_odom_robot);
    estimate();
  } else {
    carry(T_odom_robot);
  }
  belief_.outcome = outcome_of(readings);
  return belief_;
}

LocalizerOutcome MonteCarloLocalizer::outcome_of(std::span<const RangeReading> readings) const {
  if (nowhere_) {
    return *nowhere_;
  }
  if (was_off_floor_) {
    return LocalizerOutcome::kOffTheFloor;
  }
  if (!readings.empty() && std::none_of(readings.begin(), readings.end(), is_usable)) {
    return LocalizerOutcome::kNoUsableReading;
  }
  const auto is_heard = [](const RangeReading& reading) {
    return is_usable(reading) && reading.range_m;
  };
  if (!readings.empty() && std::none_of(readings.begin(), readings.end(), is_heard)) {
    return LocalizerOutcome::kSilent;
  }
  if (here_.empty()) {
    return LocalizerOutcome::kNoParticles;
  }
  return model_.count() > 0 ? LocalizerOutcome::kWeighed : LocalizerOutcome::kMoved;
}

bool MonteCarloLocalizer::has_made_a_step(const geometry::Pose2& T_odom_robot) const {
  if (!T_odom_last_) {
    return true;
  }
  const geometry::Pose2 step = T_odom_last_->inverse() * T_odom_robot;
  return step.position_m().norm() >= params_.step_m ||
         std::abs(step.heading_rad()) >= params_.step_rad;
}

bool MonteCarloLocalizer::is_on_floor(const Particles& particles) const {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto cell = model_.map().cell_at(particles.pose(i).position_m());
    if (model_.map().state(cell) == mapping::CellState::kFree) {
      return true;
    }
  }
  return false;
}

void MonteCarloLocalizer::follow(const geometry::Pose2& T_odom_robot) {
  if (T_odom_last_) {
    const models::OdometryStep step = models::odometry_step(*T_odom_last_, T_odom_robot);
    const models::MotionSpread spread = models::spread_of(params_.motion, step);
    here_.move(step, spread);
    elsewhere_.move(step, spread);
  }
  T_odom_last_ = T_odom_robot;
  T_odom_carried_ = T_odom_robot;
}

void MonteCarloLocalizer::carry(const geometry::Pose2& T_odom_robot) {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): follow() came before, which sets it
  const geometry::Pose2 step = T_odom_carried_->inverse() * T_odom_robot;
  for (PoseHypothesis& hypothesis : belief_.hypotheses) {
    hypothesis.T_map_robot = hypothesis.T_map_robot * step;
  }
  T_odom_carried_ = T_odom_robot;
  classify_status();
}

void MonteCarloLocalizer::update_weights() {
  was_off_floor_ = params_.watches_for_loss && !here_.empty() && !is_on_floor(here_.particles());
  if (was_off_floor_) {
    start_anywhere();
    gave_up_ = true;
  }
  if (here_.empty() && params_.global_start == GlobalStart::kScattered) {
    here_.start_with(scattered_particles(model_.map(), params_.filter.max_particles, random_));
  }
  if (here_.empty()) {
    look_everywhere(here_);
    return;
  }
  const double log_here = here_.update_weights(model_);
  if (!params_.watches_for_loss) {
    return;
  }
  const double a_reading =
      log_here / (here_.likelihood_exponent(model_) * static_cast<double>(model_.count()));
  if (!elsewhere_.empty()) {
    loss_.is_suspicious(a_reading);
    update_loss_probability(log_here);
  } else if (loss_.is_suspicious(a_reading)) {
    loss_.suspect();
    sweeps_elsewhere_ = 0;
    loss_.compare(log_here, look_everywhere(elsewhere_));
  }
}

void MonteCarloLocalizer::update_loss_probability(double log_here) {
  loss_.compare(log_here, elsewhere_.update_weights(model_));
  ++sweeps_elsewhere_;
  if (loss_.lost_probability() > params_.lost_above) {
    here_.join(elsewhere_, std::min(loss_.lost_probability(), 0.999));
    elsewhere_.clear();
    loss_.restart();
    gave_up_ = true;
  } else if (sweeps_elsewhere_ >= params_.suspicious_sweeps) {
    elsewhere_.clear();
    loss_.clear_suspicion();
  }
}

double MonteCarloLocalizer::look_everywhere(ParticleFilter& filter) {
  if (lattice_.size() == 0) {
    lattice_ = floor_lattice(model_.map(), params_.lattice_m, params_.lattice_rad);
  }
  model_.make_ready(lattice_, workers_);
  std::fill(lattice_.log_weight.begin(), lattice_.log_weight.end(), 0.0F);
  share_blocks(workers_, lattice_.size(), [&](ParticleRange range, std::size_t) {
    model_.update_weights(static_cast<float>(filter.likelihood_exponent(model_)), range, lattice_);
  });
  const double root_12 = std::sqrt(12.0);  // The deviation of an even spread.
  return filter.start_from(lattice_, params_.lattice_m / root_12, params_.lattice_rad / root_12) -
         std::log(static_cast<double>(std::max<std::size_t>(1, lattice_.size())));
}

void MonteCarloLocalizer::estimate() {
  belief_.hypotheses =
      find_hypotheses(here_.particles(), here_.weights(), params_.hypotheses, workers_);
  classify_status();
}

void MonteCarloLocalizer::classify_status() {
  if (belief_.hypotheses.empty()) {
    belief_.lost_probability = 1.0;
    belief_.status = LocalizationStatus::kRecovering;
    return;
  }
  const PoseHypothesis& first = belief_.hypotheses.front();
  belief_.lost_probability = 1.0 - (1.0 - loss_.lost_probability()) * first.probability;
  const double stddev_m = std::sqrt(first.covariance.topLeftCorner<2, 2>().trace());
  const bool is_one_place =
      belief_.lost_probability < params_.localized_below && stddev_m < params_.localized_stddev_m;
  belief_.status = gave_up_       ? LocalizationStatus::kLost
                   : is_one_place ? LocalizationStatus::kLocalized
                                  : LocalizationStatus::kRecovering;
}

}  // namespace echomap::localization
