// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>
#include <vector>

#include "host/localization/observation_model.hpp"
#include "host/localization/usable_reading.hpp"
#include "host/models/range_likelihood.hpp"

namespace echomap::localization {

/// A map, of whatever kind, that tells what a range sensor is to expect from a pose, and where a
/// robot can be at all.
template <typename View>
concept RangeView = requires(const View& view, const geometry::Pose2& pose) {
  { view.expected(pose) } -> std::same_as<models::ExpectedRange>;
  { view.is_floor(pose.position_m()) } -> std::same_as<bool>;
};

/// What a particle loses that is not on the floor: it is not drawn again as long as another is.
inline constexpr float kRejectedLog = -1000.0F;

/// The product of all readings' likelihoods (Singh and Bedi 2013, equation 1) by any map and any
/// model of one reading. A particle off the floor is rejected (Mukherjee et al., section V-C).
template <RangeView View, models::RangeLikelihood Model>
class ViewModel : public ObservationModel {
 public:
  /// `floor` is where a robot that may be anywhere is looked for.
  ViewModel(mapping::RasterMap floor, View view, const Model& model)
      : floor_(std::move(floor)), view_(std::move(view)), model_(model) {}

  const mapping::RasterMap& map() const override { return floor_; }

  void observe(std::span<const RangeReading> readings) override {
    readings_.clear();
    for (const RangeReading& reading : readings) {
      if (is_usable(reading)) {
        readings_.push_back(reading);
      }
    }
  }
  std::size_t count() const override { return readings_.size(); }

  void make_ready(const Particles& /*particles*/, const Workers& /*workers*/) override {}

  void update_weights(float likelihood_exponent,
                      ParticleRange range,
                      Particles& particles) const override {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const geometry::Pose2 T_map_robot = particles.pose(i);
      particles.log_weight[i] +=
          view_.is_floor(T_map_robot.position_m())
              ? likelihood_exponent * static_cast<float>(log_likelihood(T_map_robot))
              : kRejectedLog;
    }
  }

 private:
  double log_likelihood(const geometry::Pose2& T_map_robot) const {
    constexpr double kLeast = 1e-300;  // That has a logarithm.
    double sum = 0.0;
    for (const RangeReading& reading : readings_) {
      const models::ExpectedRange expected = view_.expected(T_map_robot * reading.T_robot_sensor);
      sum += std::log(std::max(model_.likelihood(reading.range_m, expected), kLeast));
    }
    return sum;
  }

  mapping::RasterMap floor_;
  View view_;
  Model model_;
  std::vector<RangeReading> readings_;
};

}  // namespace echomap::localization
