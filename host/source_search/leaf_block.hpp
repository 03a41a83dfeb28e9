// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace echomap::source_search {

/// Number of places that are processed at once.
inline constexpr std::size_t kLanes = 64;
using Lanes = std::array<float, kLanes>;

/// How the solids between a source and the sensor shield it.
struct Shielding {
  double attenuation_per_m = 0.0;
  bool is_unknown_solid = false;  ///< Unknown cells are solid as well; else they are air.
  double prior = 1.0;             ///< Sums to 1 over those that a place is combined with.
};

/// The values of strength, background and shielding that each place is combined with.
struct NuisanceNodes {
  std::vector<float> strengths;  ///< Evenly spaced logarithms.
  std::vector<float> backgrounds;
  std::vector<Shielding> shieldings;

  std::size_t per_shielding() const { return strengths.size() * backgrounds.size(); }
  std::size_t size() const { return per_shielding() * shieldings.size(); }
};

/// Square places where the source may be, and for each the log-likelihood of all readings at all
/// nuisance nodes: by shielding, background, strength, and place. Lanes without a place have no
/// area.
struct LeafBlock {
  std::array<double, kLanes> x_m{};
  std::array<double, kLanes> y_m{};
  std::array<double, kLanes> edge_m{};
  std::array<double, kLanes> area_m2{};  ///< Of the square, where the source may be.
  std::vector<float> log_likelihood;

  float* lanes(std::size_t node) { return &log_likelihood[node * kLanes]; }
  const float* lanes(std::size_t node) const { return &log_likelihood[node * kLanes]; }
};

/// A reading in the form that the kernel takes.
struct ReadingTerms {
  float value = 0.0F;                ///< Pulses, or the mean level.
  float dwell_s = 1.0F;              ///< 1 for a level.
  float saturated = 0.0F;            ///< Log-likelihood where the rate is the one observed.
  float variance = 0.0F;             ///< Of a level; 0 for pulses.
  float background_variance = 0.0F;  ///< Relative.
};

/// Response at the reading's place to a source of strength 1, by the lane of the source's place,
/// and its relative variance.
struct ResponseLanes {
  alignas(64) Lanes response{};
  alignas(64) Lanes variance{};
};

/// The log-likelihood of a reading for a rate with a relative error: of pulses the double Poisson
/// family of Efron 1986, log f = D / phi - log(phi) / 2 with D half the negative deviance and phi
/// the variance over that of a Poisson number; of a level a normal distribution.
float log_likelihood(const ReadingTerms& reading, float source, float background, float variance);

/// Computes the log-likelihoods of a reading at the nodes of one shielding: `backgrounds` times
/// `strengths` rows of lanes.
void set_log_likelihoods(const ReadingTerms& reading,
                         const ResponseLanes& responses,
                         const NuisanceNodes& nodes,
                         float* rows);

/// The largest value of each lane, over `count` rows.
Lanes row_maxima(const float* rows, std::size_t count);

/// Largest curvature of a log-likelihood from one strength to the next, over those of a row of
/// nodes that are no more than `near` below `max`.
float max_bend(const float* rows, std::size_t strengths, const Lanes& max, float near);

/// Adds `times` times `change` to as many values of `rows`.
void add_rows(const std::vector<float>& change, float times, float* rows);

}  // namespace echomap::source_search
