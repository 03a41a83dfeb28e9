// SPDX-License-Identifier: MIT
#include "host/localization/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "host/localization/motion_update.hpp"
#include "host/localization/pose_bins.hpp"
#include "host/localization/sample_size.hpp"

namespace echomap::localization {

namespace {

/// Fox's bins (2003).
constexpr PoseBinSize kSampleBins{0.2, 0.1745};

const ParticleFilterParams& checked(const ParticleFilterParams& params) {
  const bool counts_ok =
      params.least_particles > 0 && params.least_particles <= params.most_particles;
  const bool shares_ok = params.temper > 0.0 && params.temper <= 1.0 &&
                         params.resampling_share >= 0.0 && params.resampling_share <= 1.0;
  const bool spread_ok = params.spread_m >= 0.0 && params.spread_rad >= 0.0;
  if (!counts_ok || !shares_ok || !spread_ok || !(params.sample_error > 0.0)) {
    throw std::invalid_argument(
        "particle filter: at least one particle, and at most no fewer; temper within (0, 1], a "
        "resampling share within [0, 1], an error above 0 and a spread not below");
  }
  return params;
}

RandomKey key_of(std::mt19937& random) {
  const auto first = static_cast<std::uint32_t>(random());
  return {first, static_cast<std::uint32_t>(random())};
}

void append(const std::vector<float>& more, std::vector<float>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

void add_to_all(float term, std::vector<float>& values) {
  for (float& value : values) {
    value += term;
  }
}

}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterParams& params, std::mt19937 random)
    : params_(checked(params)), random_(random) {}

void ParticleFilter::start_at(const geometry::Pose2& T_map_robot, double std_m, double std_rad) {
  particles_.resize(params_.most_particles);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_.set_pose(i, T_map_robot);
  }
  std::fill(particles_.log_weight.begin(), particles_.log_weight.end(), 0.0F);
  scatter(std_m, std_rad);
}

void ParticleFilter::start_from(const Particles& weighed, double std_m, double std_rad) {
  if (weighed.size() == 0) {
    clear();
    return;
  }
  relative_weights(weighed, weights_);
  draw(weighed, params_.most_particles);
  scatter(std_m, std_rad);
}

void ParticleFilter::move(const models::OdometryStep& step, const models::MotionSpread& spread) {
  localization::move(particles_, {0, particles_.size()}, step, spread, key_of(random_));
}

double ParticleFilter::weigh(const CodedReadings& readings, RangeTable& table) {
  const double before = log_total_weight(particles_);
  fill_under(particles_, readings, table);
  localization::weigh(
      table, readings, static_cast<float>(params_.temper), {0, particles_.size()}, particles_);
  return log_total_weight(particles_) - before;
}

void ParticleFilter::resample_where_few_count() {
  relative_weights(particles_, weights_);
  const auto count = static_cast<double>(particles_.size());
  if (effective_count(weights_) >= params_.resampling_share * count) {
    return;
  }
  draw(particles_, particles_.size());
  const std::size_t wanted = wanted_count();
  if (wanted < particles_.size()) {
    weights_.assign(particles_.size(), 1.0F);
    draw(particles_, wanted);
  }
  scatter(params_.spread_m, params_.spread_rad);
}

void ParticleFilter::join(const ParticleFilter& other, double share) {
  Particles others = other.particles_;
  add_to_all(static_cast<float>(std::log(1.0 - share) - log_total_weight(particles_)),
             particles_.log_weight);
  add_to_all(static_cast<float>(std::log(share) - log_total_weight(others)), others.log_weight);
  append(others.x_m, particles_.x_m);
  append(others.y_m, particles_.y_m);
  append(others.heading_rad, particles_.heading_rad);
  append(others.log_weight, particles_.log_weight);
  relative_weights(particles_, weights_);
  draw(particles_, std::min(particles_.size(), params_.most_particles));
  scatter(params_.spread_m, params_.spread_rad);
}

/// By `weights_`.
void ParticleFilter::draw(const Particles& from, std::size_t count) {
  draw_ancestors(weights_, count, params_.scheme, random_, ancestors_);
  take_ancestors(from, ancestors_, spare_);
  std::swap(particles_, spare_);
}

std::size_t ParticleFilter::wanted_count() const {
  PoseBins bins(kSampleBins);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    bins.insert(bins.bin_at(particles_.x_m[i],
                            particles_.y_m[i],
                            static_cast<double>(particles_.heading_rad[i]) + std::numbers::pi));
  }
  return std::clamp(kld_sample_size(bins.size(), params_.sample_error),
                    params_.least_particles,
                    params_.most_particles);
}

void ParticleFilter::scatter(double std_m, double std_rad) {
  move({}, {std_rad, std_m, 0.0, std_m});
}

double log_total_weight(const Particles& particles) {
  if (particles.size() == 0) {
    return 0.0;
  }
  const float greatest =
      *std::max_element(particles.log_weight.begin(), particles.log_weight.end());
  double sum = 0.0;
  for (const float log_weight : particles.log_weight) {
    sum += static_cast<double>(exp_of_negative(log_weight - greatest));
  }
  return static_cast<double>(greatest) + std::log(sum);
}

}  // namespace echomap::localization
