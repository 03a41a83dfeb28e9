// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "host/localization/likelihood_field.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/range_update.hpp"
#include "host/localization/workers.hpp"

namespace echomap::bench {

/// Particles of a robot that is followed: around a pose in the middle of a room of the building.
localization::Particles tracking_cloud(std::size_t count);

/// So many readings all round, of 1 m to 3.5 m, the same at each call.
std::vector<localization::RangeReading> sweep(int beams);

/// A whole step of a particle filter by a likelihood field and 60 beams: move, weigh, find the
/// hypotheses and draw anew. The robot stands.
class FilterStep {
 public:
  /// The field must outlive this.
  FilterStep(const localization::LikelihoodField& field, std::size_t particles, int threads);

  void operator()();

  const localization::Particles& particles() const { return particles_; }

 private:
  const localization::LikelihoodField& field_;
  localization::Workers workers_;
  std::vector<localization::RangeReading> readings_ = sweep(60);
  std::mt19937 random_{4};
  localization::Particles particles_;
  localization::Particles drawn_;
  std::vector<float> weights_;
  std::vector<std::uint32_t> ancestors_;
};

}  // namespace echomap::bench
