// SPDX-License-Identifier: MIT
#include "hil_mock/world/noise.hpp"

#include <cmath>
#include <numbers>

namespace echomap::world {
namespace {

/// Finalizer of MurmurHash3: neighbouring seeds and purposes start far apart.
std::uint32_t mix(std::uint32_t value) {
  value = (value ^ (value >> 16U)) * 0x85EBCA6BU;
  value = (value ^ (value >> 13U)) * 0xC2B2AE35U;
  return value ^ (value >> 16U);
}

}  // namespace

NoiseStream::NoiseStream(std::uint32_t seed, NoisePurpose purpose)
    : generator_(mix(mix(seed) + static_cast<std::uint32_t>(purpose))) {}

std::uint32_t seed_of(std::uint32_t shared, std::uint32_t number) {
  constexpr std::uint32_t kStride = 0x9E3779B9U;
  return number == 0 ? shared : mix(mix(shared) + kStride * number);
}

double NoiseStream::uniform() { return static_cast<double>(generator_()) / 4294967296.0; }

double NoiseStream::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace echomap::world
