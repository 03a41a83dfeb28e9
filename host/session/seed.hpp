// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace echomap::session {

/// What random numbers of a run are for.
enum class SeedPurpose : std::uint32_t {
  kStrategy = 0,
  kLocalizer = 1,
};

/// The seed of a run, from which every random number of it comes.
class Seed {
 public:
  explicit Seed(std::uint32_t number) : number_(number) {}

  /// The number that the user gave: for reports, and for programs that make streams of their own of
  /// it, as the simulated robot does.
  std::uint32_t number() const { return number_; }

  /// Makes the generator of one purpose; the streams of two purposes are independent. The strategy
  /// has the plain stream of the number, so that the runs of a seed are those that are published.
  std::mt19937 generator(SeedPurpose purpose) const {
    if (purpose == SeedPurpose::kStrategy) {
      return std::mt19937(number_);
    }
    std::seed_seq mixed{number_, static_cast<std::uint32_t>(purpose)};
    return std::mt19937(mixed);
  }

 private:
  std::uint32_t number_;
};

}  // namespace echomap::session
