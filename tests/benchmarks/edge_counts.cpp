// SPDX-License-Identifier: MIT
#include "tests/benchmarks/edge_counts.hpp"

#include <algorithm>
#include <limits>

namespace echomap::bench {

std::string suffix_of(int rate_k, int jitter_percent) {
  return std::to_string(rate_k) + "k_jitter" + std::to_string(jitter_percent);
}

std::vector<Figure> figures_of(const std::vector<EdgeCount>& counts) {
  std::vector<Figure> figures;
  for (const EdgeCount& count : counts) {
    const std::string suffix = suffix_of(count.rate_k, count.jitter_percent);
    const auto runs = static_cast<std::size_t>(count.comparisons);
    if (count.comparisons > 0) {
      figures.push_back({"miscounts_" + suffix, double(count.miscounts), "ticks", runs, {}});
    }
    figures.push_back({"lost_steps_" + suffix, double(count.lost_steps), "", 1, {}});
    figures.push_back({"resets_" + suffix, double(count.resets), "", 1, {}});
  }
  return figures;
}

double worst_miscounts(const std::vector<EdgeCount>& counts) {
  double worst = 0.0;
  for (const EdgeCount& count : counts) {
    worst = std::max(
        worst,
        count.comparisons > 0 ? double(count.miscounts) : std::numeric_limits<double>::infinity());
  }
  return worst;
}

}  // namespace echomap::bench
