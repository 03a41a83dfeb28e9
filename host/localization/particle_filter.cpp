// SPDX-License-Identifier: MIT
#include "host/localization/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/localization/pose_bins.hpp"
#include "host/localization/sample_size.hpp"

namespace echomap::localization {

namespace {

/// Fox's bins (2003).
constexpr PoseBinSize kSampleBins{0.2, 0.1745};

const ParticleFilterParams& validated(const ParticleFilterParams& params) {
  const bool counts_ok = params.min_particles > 0 && params.min_particles <= params.max_particles;
  const bool shares_ok = params.likelihood_exponent > 0.0 && params.likelihood_exponent <= 1.0 &&
                         params.max_independent > 0.0 && params.resampling_share >= 0.0 &&
                         params.resampling_share <= 1.0;
  const bool spread_ok = params.spread_m >= 0.0 && params.spread_rad >= 0.0;
  if (!counts_ok || !shares_ok || !spread_ok || !(params.sample_error > 0.0)) {
    throw std::invalid_argument(
        "particle filter: 1 <= min_particles <= max_particles, 0 < likelihood_exponent <= 1, 0 <= "
        "resampling_share <= 1, sample_error > 0 and spread_m >= 0 must hold");
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

ParticleFilter::ParticleFilter(const ParticleFilterParams& params,
                               std::mt19937 random,
                               Workers workers)
    : params_(validated(params)), random_(random), workers_(std::move(workers)) {}

void ParticleFilter::clear() {
  particles_.resize(0);
  equalize_weights();
}

void ParticleFilter::start_at(const geometry::Pose2& T_map_robot,
                              double stddev_m,
                              double stddev_rad) {
  particles_.resize(params_.max_particles);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_.set_pose(i, T_map_robot);
  }
  std::fill(particles_.log_weight.begin(), particles_.log_weight.end(), 0.0F);
  equalize_weights();
  scatter(stddev_m, stddev_rad);
}

void ParticleFilter::start_with(Particles particles) {
  particles_ = std::move(particles);
  equalize_weights();
}

double ParticleFilter::start_from(const Particles& weighted, double stddev_m, double stddev_rad) {
  if (weighted.size() == 0) {
    clear();
    return 0.0;
  }
  const WeightSums sums = relative_weights(weighted, weights_, workers_);
  draw(weighted, params_.max_particles);
  scatter(stddev_m, stddev_rad);
  return sums.log_total();
}

void ParticleFilter::move(const models::OdometryStep& step, const models::MotionSpread& spread) {
  const RandomKey key = key_of(random_);
  share_blocks(workers_, particles_.size(), [&](ParticleRange range, std::size_t) {
    localization::move(particles_, range, step, spread, key, params_.motion_noise);
  });
}

double ParticleFilter::likelihood_exponent(const ObservationModel& model) const {
  const auto count = static_cast<double>(std::max<std::size_t>(1, model.count()));
  return std::min(params_.likelihood_exponent, params_.max_independent / count);
}

double ParticleFilter::update_weights(ObservationModel& model) {
  const double before = sums_.log_total();
  const auto share = static_cast<float>(likelihood_exponent(model));
  model.make_ready(particles_, workers_);
  share_blocks(workers_, particles_.size(), [&](ParticleRange range, std::size_t) {
    model.update_weights(share, range, particles_);
  });
  sums_ = relative_weights(particles_, weights_, workers_);
  return sums_.log_total() - before;
}

void ParticleFilter::resample_if_needed() {
  const auto count = static_cast<double>(particles_.size());
  if (sums_.effective_count() >= params_.resampling_share * count) {
    return;
  }
  draw(particles_, particles_.size());
  const std::size_t wanted = wanted_count();
  if (wanted < particles_.size()) {
    draw(particles_, wanted);
  }
  scatter(params_.spread_m, params_.spread_rad);
}

void ParticleFilter::join(const ParticleFilter& other, double share) {
  Particles others = other.particles_;
  add_to_all(static_cast<float>(std::log(1.0 - share) - sums_.log_total()), particles_.log_weight);
  add_to_all(static_cast<float>(std::log(share) - other.sums_.log_total()), others.log_weight);
  append(others.x_m, particles_.x_m);
  append(others.y_m, particles_.y_m);
  append(others.heading_rad, particles_.heading_rad);
  append(others.log_weight, particles_.log_weight);
  relative_weights(particles_, weights_, workers_);
  draw(particles_, std::min(particles_.size(), params_.max_particles));
  scatter(params_.spread_m, params_.spread_rad);
}

void ParticleFilter::equalize_weights() {
  const auto count = static_cast<double>(particles_.size());
  weights_.assign(particles_.size(), 1.0F);
  sums_ = {0.0, count, count};
}

/// By `weights_`, which are equal then.
void ParticleFilter::draw(const Particles& from, std::size_t count) {
  draw_ancestors(weights_, count, params_.scheme, random_, ancestors_, workers_);
  take_ancestors(from, ancestors_, spare_, workers_);
  std::swap(particles_, spare_);
  equalize_weights();
}

std::size_t ParticleFilter::wanted_count() const {
  PoseBins bins(kSampleBins);
  BinnedStretch stretch;
  for (std::size_t begin = 0; begin < particles_.size(); begin += BinnedStretch::kMost) {
    const std::size_t count = std::min(BinnedStretch::kMost, particles_.size() - begin);
    bins.locate(particles_, {begin, begin + count}, stretch);
    for (std::size_t i = 0; i < count; ++i) {
      bins.insert(stretch.bin(i));
    }
  }
  return std::clamp(kld_sample_size(bins.size(), params_.sample_error),
                    params_.min_particles,
                    params_.max_particles);
}

void ParticleFilter::scatter(double stddev_m, double stddev_rad) {
  move({}, {stddev_rad, stddev_m, 0.0, stddev_m});
}

}  // namespace echomap::localization
