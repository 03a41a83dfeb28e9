// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace echomap::session {

/// What random numbers of a run are for. All values are 0 today, so that all streams of one seed
/// are the same numbers, as in the runs that are published; another value would tell a stream
/// apart.
enum class SeedPurpose : std::uint32_t {
  kSimulation = 0,  ///< The world, the body and the line, in the simulated robot's own program.
  kSessionId = 0,   ///< Of a simulated robot; that of a real one has to be new every time.
  kStrategy = 0,
  kLocalizer = 0,
  kStopDriver = 0,
};

/// The seed of a run, from which every random number of it comes.
class Seed {
 public:
  explicit Seed(std::uint32_t number) : number_(number) {}

  /// That of one stream, for a program or a class that makes its own generator of it.
  std::uint32_t of(SeedPurpose purpose) const {
    return number_ ^ static_cast<std::uint32_t>(purpose);
  }
  std::mt19937 generator(SeedPurpose purpose) const { return std::mt19937(of(purpose)); }

 private:
  std::uint32_t number_;
};

}  // namespace echomap::session
