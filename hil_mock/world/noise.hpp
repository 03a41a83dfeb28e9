// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

namespace echomap::world {

/// What a stream of random numbers is for; each purpose has its own, so that a change of one
/// physics does not shift another's numbers.
enum class NoisePurpose : std::uint32_t {
  kBody = 1,
  kSonar = 2,
  kLineFaults = 3,
  kLineDelays = 4,
  kGyro = 5,
  kBattery = 6,
  kPlaces = 7,
  kCamera = 8,
  kEncoderDirt = 9,
  kStarts = 10,
  kScalarSensor = 11,
  kRange0 = 16,  ///< .. 23, one for each infra-red channel.
};

/// Seeded random numbers whose values repeat with any standard library: the generator is the
/// standard's mt19937, the transformations are ours.
class NoiseStream {
 public:
  NoiseStream(std::uint32_t seed, NoisePurpose purpose);

  /// Uniform in [0, 1), one draw of the generator.
  double uniform();
  /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958), always two draws.
  double normal();

 private:
  std::mt19937 generator_;
};

/// A seed for one of several that share one, numbered from 0, whose own it is.
std::uint32_t seed_of(std::uint32_t shared, std::uint32_t number);

}  // namespace echomap::world
