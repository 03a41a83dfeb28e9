// SPDX-License-Identifier: MIT
#include "host/source_search/leaf_block.hpp"

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::source_search {

namespace {

using localization::log_of;

/// A place, as one node has it.
struct NodeRate {
  float strength;
  float background;  ///< Of a reading, not of a second.
};

[[gnu::always_inline]] inline float of_pulses(const ReadingTerms& reading,
                                              float source,
                                              float background,
                                              float source_variance) {
  const float mean = source + background;
  const float excess =
      source_variance * source * source + reading.background_variance * background * background;
  const float dispersion = 1.0F + excess / mean;
  const float deviance = reading.value * log_of(mean) - mean - reading.saturated;
  return deviance / dispersion - 0.5F * log_of(dispersion);
}

[[gnu::always_inline]] inline float of_level(const ReadingTerms& reading,
                                             float source,
                                             float background,
                                             float source_variance) {
  const float error = reading.value - source - background;
  const float excess =
      source_variance * source * source + reading.background_variance * background * background;
  const float spread = 1.0F + excess / reading.variance;
  return -0.5F * (error * error / (reading.variance * spread) + log_of(spread));
}

ECHOMAP_VECTOR_CLONES
void set_pulses(const ReadingTerms& reading,
                const NodeRate& node,
                const float* __restrict response,
                const float* __restrict variance,
                float* __restrict lanes) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    lanes[i] = of_pulses(reading, node.strength * response[i], node.background, variance[i]);
  }
}

ECHOMAP_VECTOR_CLONES
void set_level(const ReadingTerms& reading,
               const NodeRate& node,
               const float* __restrict response,
               const float* __restrict variance,
               float* __restrict lanes) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    lanes[i] = of_level(reading, node.strength * response[i], node.background, variance[i]);
  }
}

}  // namespace

float log_likelihood(const ReadingTerms& reading, float source, float background, float variance) {
  return reading.variance > 0.0F ? of_level(reading, source, background, variance)
                                 : of_pulses(reading, source, background, variance);
}

void set_log_likelihoods(const ReadingTerms& reading,
                         const ResponseLanes& responses,
                         const NuisanceNodes& nodes,
                         float* rows) {
  const auto set = reading.variance > 0.0F ? set_level : set_pulses;
  for (const float background : nodes.backgrounds) {
    for (const float strength : nodes.strengths) {
      const NodeRate node{strength * reading.dwell_s, background * reading.dwell_s};
      set(reading, node, responses.response.data(), responses.variance.data(), rows);
      rows += kLanes;
    }
  }
}

ECHOMAP_VECTOR_CLONES
Lanes row_maxima(const float* rows, std::size_t count) {
  Lanes maxima;
  maxima.fill(-1e30F);
  for (std::size_t row = 0; row < count; ++row) {
    const float* __restrict values = rows + row * kLanes;
    for (std::size_t i = 0; i < kLanes; ++i) {
      maxima[i] = maxima[i] < values[i] ? values[i] : maxima[i];
    }
  }
  return maxima;
}

ECHOMAP_VECTOR_CLONES
float max_bend(const float* rows, std::size_t strengths, const Lanes& max, float near) {
  Lanes bends{};
  for (std::size_t s = 1; s + 1 < strengths; ++s) {
    const float* __restrict here = rows + s * kLanes;
    const float* __restrict before = here - kLanes;
    const float* __restrict after = here + kLanes;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float bend = 2.0F * here[i] - before[i] - after[i];
      const float counted = here[i] > max[i] - near ? bend : 0.0F;
      bends[i] = bends[i] < counted ? counted : bends[i];
    }
  }
  float most = 0.0F;
  for (const float bend : bends) {
    most = most < bend ? bend : most;
  }
  return most;
}

ECHOMAP_VECTOR_CLONES
void add_rows(const std::vector<float>& change, float times, float* rows) {
  const float* from = change.data();
  const std::size_t count = change.size();
  for (std::size_t i = 0; i < count; ++i) {
    rows[i] += times * from[i];
  }
}

}  // namespace echomap::source_search
