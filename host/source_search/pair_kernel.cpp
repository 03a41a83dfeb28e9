// SPDX-License-Identifier: MIT
#include "host/source_search/pair_kernel.hpp"

#include <array>

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::source_search {

ECHOMAP_VECTOR_CLONES
void add_pair_distances(const float* __restrict features,
                        std::size_t count,
                        float feature,
                        float dwell_s,
                        float* __restrict distances) {
  for (std::size_t i = 0; i < count; ++i) {
    const float difference = features[i] - feature;
    distances[i] += 0.5F * dwell_s * (difference * difference);
  }
}

ECHOMAP_VECTOR_CLONES
PairSums sum_pairs(const float* __restrict distances,
                   const float* __restrict similar_weights,
                   const float* __restrict weights,
                   std::size_t count) {
  constexpr std::size_t kWidth = 16;
  std::array<float, kWidth> similar{};
  std::array<float, kWidth> all{};
  for (std::size_t first = 0; first < count; first += kWidth) {
    for (std::size_t i = 0; i < kWidth; ++i) {
      const float likeness = localization::exp_of_negative(-distances[first + i]);
      similar[i] += similar_weights[first + i] * likeness;
      all[i] += weights[first + i] * likeness;
    }
  }
  PairSums sums;
  for (std::size_t i = 0; i < kWidth; ++i) {
    sums.similar += similar[i];
    sums.all += all[i];
  }
  return sums;
}

}  // namespace echomap::source_search
