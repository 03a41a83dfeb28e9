// SPDX-License-Identifier: MIT
#include "tests/benchmarks/localization_scaling.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/benchmarks/localization_workloads.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

double wall_seconds(FilterStep& step, int steps) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) {
    step();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processes that ran or waited over the last minute; -1 where that is not told.
double load() {
  double average = -1.0;
  getloadavg(&average, 1);
  return average;
}

/// Of the fastest: others on the machine take a processor away at nearly any time.
Figure two_threads(const localization::LikelihoodField& field,
                   std::size_t particles,
                   const std::string& name,
                   std::size_t pairs) {
  FilterStep alone(field, particles, 1);
  FilterStep together(field, particles, 2);
  const int steps = static_cast<int>(100'000 / particles);
  double alone_s = wall_seconds(alone, steps);
  double together_s = wall_seconds(together, steps);
  for (std::size_t i = 0; i < pairs; ++i) {
    alone_s = std::min(alone_s, wall_seconds(alone, steps));
    together_s = std::min(together_s, wall_seconds(together, steps));
  }
  fmt::print("{}: the machine's load was {:.1f}\n", name, load());
  return {name, alone_s / together_s, "times", pairs, {}};
}

Figure step_ns(const localization::LikelihoodField& field,
               const std::string& name,
               std::size_t particles,
               std::size_t repetitions) {
  FilterStep step(field, particles, 1);
  std::vector<double> seconds;
  for (std::size_t i = 0; i <= repetitions; ++i) {
    const double took_s = processor_seconds(step);
    if (i > 0) {
      seconds.push_back(took_s);
    }
  }
  return {
      name, 1e9 * tests::median(seconds) / static_cast<double>(particles), "ns", repetitions, {}};
}

}  // namespace

std::vector<Figure> localization_scaling_figures(const mapping::RasterMap& map,
                                                 std::size_t repetitions) {
  const localization::LikelihoodField field(map);
  const std::size_t few = repetitions / 5 + 1;
  return {step_ns(field, "full_step_60_100k_ns", 100'000, few),
          step_ns(field, "full_step_60_1m_ns", 1'000'000, few),
          two_threads(field, 10'000, "two_thread_speedup", 8 * repetitions),
          two_threads(field, 100'000, "two_thread_speedup_100k", 8 * repetitions)};
}

}  // namespace echomap::bench
