// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exchange_figures.hpp"

#include <exception>

#include <fmt/format.h>

#include "tests/support/faulty_fleet.hpp"
#include "tests/support/late_join.hpp"

namespace echomap::bench {
namespace {

bool has_all(const tests::FaultyFleetRun& run) {
  return run.is_same && run.late_objects >= tests::kMinFaultyFleetObjects &&
         run.late_objects <= tests::kMaxFaultyFleetObjects;
}

/// One that throws has not converged.
tests::FaultyFleetRun try_run(std::uint32_t seed) {
  try {
    return tests::run_faulty_fleet(seed);
  } catch (const std::exception& error) {
    fmt::print(stderr, "exchange, seed {}: {}\n", seed, error.what());
    return {};
  }
}

}  // namespace

std::vector<Figure> exchange_figures(std::uint32_t seeds) {
  constexpr std::size_t kObjects = 10'000;
  double converged = 0.0;
  double bytes_per_s = 0.0;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const tests::FaultyFleetRun run = try_run(seed);
    converged += has_all(run) ? 1.0 : 0.0;
    bytes_per_s += run.bytes_per_s / seeds;
    if (!has_all(run)) {
      fmt::print(stderr,
                 "exchange, seed {}: {}, {} objects\n",
                 seed,
                 run.is_same ? "the same" : "not the same",
                 run.late_objects);
    }
  }
  const tests::LateJoin late = tests::join_late(kObjects);
  return {{"converged_of_40", converged, "", seeds, {}},
          {"kbytes_per_s_per_robot_with_faults", 1e-3 * bytes_per_s, "kB/s", seeds, {}},
          {"late_join_objects", static_cast<double>(late.objects), "", 1, {}},
          {"late_join_s", late.seconds, "s", 1, {}}};
}

}  // namespace echomap::bench
