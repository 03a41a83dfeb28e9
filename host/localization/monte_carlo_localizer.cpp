// SPDX-License-Identifier: MIT
#include "host/localization/monte_carlo_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/localization/floor_lattice.hpp"

namespace echomap::localization {

namespace {

const LocalizerParams& checked(const LocalizerParams& params) {
  if (!(params.lattice_m > 0.0) || !(params.lattice_rad > 0.0) || params.suspicious_sweeps < 1) {
    throw std::invalid_argument("localizer: a lattice's steps and the sweeps are above 0");
  }
  return params;
}

/// Another generator than one with the same seed.
std::mt19937 branch_of(std::mt19937 random) {
  return std::mt19937(static_cast<std::uint32_t>(random()));
}

}  // namespace

MonteCarloLocalizer::MonteCarloLocalizer(RangeTable& table,
                                         const LikelihoodCodes& likelihoods,
                                         const LocalizerParams& params,
                                         std::mt19937 random)
    : table_(table),
      likelihoods_(likelihoods),
      params_(checked(params)),
      workers_(params.threads),
      motion_(params.motion),
      here_(params.filter, random, workers_),
      elsewhere_(params.filter, branch_of(random), workers_),
      loss_(params.loss) {}

void MonteCarloLocalizer::start_at(const geometry::Pose2& T_map_robot,
                                   double std_m,
                                   double std_rad) {
  here_.start_at(T_map_robot, std_m, std_rad);
  elsewhere_.clear();
  loss_.restart();
  believe();
}

void MonteCarloLocalizer::start_anywhere() {
  here_.clear();
  elsewhere_.clear();
  loss_.restart();
  believe();
}

const PoseBelief& MonteCarloLocalizer::update(const geometry::Pose2& T_odom_robot,
                                              std::span<const RangeReading> readings) {
  gave_up_ = false;
  follow(T_odom_robot);
  const CodedReadings coded(readings, table_, likelihoods_);
  if (coded.count() > 0) {
    weigh_readings(coded);
    here_.resample_where_few_count();
    elsewhere_.resample_where_few_count();
  }
  believe();
  return belief_;
}

void MonteCarloLocalizer::follow(const geometry::Pose2& T_odom_robot) {
  if (T_odom_last_) {
    const models::OdometryStep step = models::odometry_step(*T_odom_last_, T_odom_robot);
    const models::MotionSpread spread = motion_.spread(step);
    here_.move(step, spread);
    elsewhere_.move(step, spread);
  }
  T_odom_last_ = T_odom_robot;
}

void MonteCarloLocalizer::weigh_readings(const CodedReadings& readings) {
  if (here_.empty()) {
    look_everywhere(readings, here_);
    return;
  }
  const double log_here = here_.weigh(readings, table_);
  const double a_reading =
      log_here / (params_.filter.temper * static_cast<double>(readings.count()));
  if (!elsewhere_.empty()) {
    loss_.is_suspicious(a_reading);
    judge(readings, log_here);
  } else if (loss_.is_suspicious(a_reading)) {
    loss_.suspect();
    sweeps_elsewhere_ = 0;
    loss_.compare(log_here, look_everywhere(readings, elsewhere_));
  }
}

void MonteCarloLocalizer::judge(const CodedReadings& readings, double log_here) {
  loss_.compare(log_here, elsewhere_.weigh(readings, table_));
  ++sweeps_elsewhere_;
  if (loss_.lost_probability() > params_.lost_above) {
    here_.join(elsewhere_, std::min(loss_.lost_probability(), 0.999));
    elsewhere_.clear();
    loss_.restart();
    gave_up_ = true;
  } else if (sweeps_elsewhere_ >= params_.suspicious_sweeps) {
    elsewhere_.clear();
    loss_.trust();
  }
}

double MonteCarloLocalizer::look_everywhere(const CodedReadings& readings, ParticleFilter& filter) {
  if (lattice_.size() == 0) {
    lattice_ = floor_lattice(table_, params_.lattice_m, params_.lattice_rad);
  }
  fill_under(lattice_, readings, table_, workers_);
  std::fill(lattice_.log_weight.begin(), lattice_.log_weight.end(), 0.0F);
  share_blocks(workers_, lattice_.size(), [&](ParticleRange range, std::size_t) {
    weigh(table_, readings, static_cast<float>(params_.filter.temper), range, lattice_);
  });
  const double root_12 = std::sqrt(12.0);  // The deviation of an even spread.
  return filter.start_from(lattice_, params_.lattice_m / root_12, params_.lattice_rad / root_12) -
         std::log(static_cast<double>(std::max<std::size_t>(1, lattice_.size())));
}

void MonteCarloLocalizer::believe() {
  belief_.hypotheses = find_hypotheses(here_.particles(), here_.weights(), {}, workers_);
  if (belief_.hypotheses.empty()) {
    belief_.lost_probability = 1.0;
    belief_.status = LocalizationStatus::kRecovering;
    return;
  }
  const PoseHypothesis& first = belief_.hypotheses.front();
  belief_.lost_probability = 1.0 - (1.0 - loss_.lost_probability()) * first.probability;
  const double std_m = std::sqrt(first.covariance.topLeftCorner<2, 2>().trace());
  const bool is_one_place =
      belief_.lost_probability < params_.localized_below && std_m < params_.localized_std_m;
  belief_.status = gave_up_       ? LocalizationStatus::kLost
                   : is_one_place ? LocalizationStatus::kLocalized
                                  : LocalizationStatus::kRecovering;
}

}  // namespace echomap::localization
