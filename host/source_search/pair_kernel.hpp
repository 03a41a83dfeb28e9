// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace echomap::source_search {

/// For each of `count` numbers adds half the squared difference to `feature`, times `dwell_s`.
void add_pair_distances(
    const float* features, std::size_t count, float feature, float dwell_s, float* distances);

/// Sums over a row of distances.
struct PairSums {
  float similar = 0.0F;
  float all = 0.0F;
};

/// Weighted sums of exp(-distance); `count` is a multiple of 16.
PairSums sum_pairs(const float* distances,
                   const float* similar_weights,
                   const float* weights,
                   std::size_t count);

}  // namespace echomap::source_search
