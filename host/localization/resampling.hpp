// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "host/localization/particles.hpp"
#include "host/localization/workers.hpp"

namespace echomap::localization {

/// How the particles that live on are drawn, each about as often as its weight asks.
enum class ResamplingScheme : std::uint8_t {
  kSystematic,  ///< One random number, then even steps (low variance; Thrun et al. 2005,
                ///< table 4.4).
  kWheel,       ///< Random steps around a wheel (Singh and Bedi 2013, Algorithm 2).
};

/// Draws `count` numbers of particles by their weights, which are not negative and not all 0. In
/// the order of the particles, save from the wheel. Only the systematic scheme shares out its work.
void draw_ancestors(std::span<const float> weights,
                    std::size_t count,
                    ResamplingScheme scheme,
                    std::mt19937& random,
                    std::vector<std::uint32_t>& ancestors,
                    const Workers& workers = Workers());

/// The poses of the ancestors, all of the same weight.
void take_ancestors(const Particles& before,
                    std::span<const std::uint32_t> ancestors,
                    Particles& after,
                    const Workers& workers = Workers());

/// Sums over the weights of particles, relative to the greatest.
struct WeightSums {
  double log_greatest = 0.0;
  double sum = 0.0;
  double squares = 0.0;

  /// The logarithm of the sum of all weights; 0 for no particles.
  double log_total() const;
  /// 1 / sum of the squares of the normalized weights: how many particles count (Kong, Liu and Wong
  /// 1994). 0 for no particles.
  double effective_count() const;
};

/// exp(log weight - the greatest), so that the greatest is 1.
WeightSums relative_weights(const Particles& particles,
                            std::vector<float>& weights,
                            const Workers& workers = Workers());

}  // namespace echomap::localization
