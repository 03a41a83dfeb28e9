// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace echomap::localization {

/// Arithmetic for loops over particles: without branches and calls, so that a compiler makes
/// vectors of it. Sources that use it are compiled with -fno-math-errno and without contraction, so
/// that every processor comes to the same bits.

/// Of one angle.
struct SinCos {
  float sin = 0.0F;
  float cos = 1.0F;
};

/// Added to a number within +- 4 million it leaves the nearest whole one in the lowest bits.
inline constexpr float kRounding = 0x1.8p23F;

/// `number` with another sign where `bits` has its highest one set.
[[gnu::always_inline]] inline float sign_turned(float number, std::uint32_t bits) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) ^ (bits & 0x80000000U));
}

/// Of an angle within +- 50, right to 2e-6. Taylor's series within an eighth of a turn.
[[gnu::always_inline]] inline SinCos sin_cos(float angle_rad) {
  constexpr float kQuartersPerRad = 2.0F / std::numbers::pi_v<float>;
  // pi / 2 in two parts, the first of which has few bits: its multiples are exact.
  constexpr float kQuarterHigh = 1.5703125F;
  constexpr float kQuarterLow = 4.8382679e-4F;
  const float rounded = angle_rad * kQuartersPerRad + kRounding;
  const auto quarter = std::bit_cast<std::uint32_t>(rounded);
  const float count = rounded - kRounding;
  const float rest = (angle_rad - count * kQuarterHigh) - count * kQuarterLow;
  const float square = rest * rest;
  const float sine =
      rest *
      (1.0F + square * (-1.0F / 6.0F + square * (1.0F / 120.0F - square * (1.0F / 5040.0F))));
  const float cosine =
      1.0F + square * (-0.5F + square * (1.0F / 24.0F +
                                         square * (-1.0F / 720.0F + square * (1.0F / 40320.0F))));
  // Sine and cosine change places in odd quarters.
  const auto sine_bits = std::bit_cast<std::uint32_t>(sine);
  const auto cosine_bits = std::bit_cast<std::uint32_t>(cosine);
  const std::uint32_t changed = (sine_bits ^ cosine_bits) & (0U - (quarter & 1U));
  return {sign_turned(std::bit_cast<float>(sine_bits ^ changed), quarter << 30U),
          sign_turned(std::bit_cast<float>(cosine_bits ^ changed), (quarter + 1U) << 30U)};
}

/// The same direction in [-pi, pi], of an angle within +- 50.
[[gnu::always_inline]] inline float wrapped(float angle_rad) {
  constexpr float kTurnsPerRad = 0.5F / std::numbers::pi_v<float>;
  const float whole = (angle_rad * kTurnsPerRad + kRounding) - kRounding;
  return angle_rad - whole * (2.0F * std::numbers::pi_v<float>);
}

/// e to the `power`, which is at most 0; 0 below -87; right to 5e-6 of itself.
[[gnu::always_inline]] inline float exp_of_negative(float power) {
  constexpr float kLn2 = std::numbers::ln2_v<float>;
  const float doublings = (power < -87.0F ? -87.0F : power) * (1.0F / kLn2);
  const auto whole = static_cast<std::int32_t>(doublings - 0.5F);
  const float rest = (doublings - static_cast<float>(whole)) * kLn2;
  const float series =
      1.0F +
      rest * (1.0F +
              rest * (0.5F + rest * (1.0F / 6.0F +
                                     rest * (1.0F / 24.0F +
                                             rest * (1.0F / 120.0F + rest * (1.0F / 720.0F))))));
  const float value = std::bit_cast<float>((whole + 127) << 23) * series;
  // A choice between numbers would become a branch.
  const std::int32_t kept_bits = power < -87.0F ? 0 : -1;
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(value) & kept_bits);
}

/// The natural logarithm of a number above 0 that is not denormal, right to 2e-6.
[[gnu::always_inline]] inline float log_of(float number) {
  const auto bits = std::bit_cast<std::int32_t>(number);
  // So that the mantissa lies in [2/3, 4/3).
  const std::int32_t exponent = (bits - 0x3F2AAAAB) >> 23;
  const float mantissa = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float ratio = (mantissa - 1.0F) / (mantissa + 1.0F);
  const float square = ratio * ratio;
  const float series =
      ratio *
      (2.0F + square * (2.0F / 3.0F +
                        square * (2.0F / 5.0F + square * (2.0F / 7.0F + square * (2.0F / 9.0F)))));
  return static_cast<float>(exponent) * std::numbers::ln2_v<float> + series;
}

/// What makes the random numbers of one update: two words of the caller's generator.
struct RandomKey {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Random bits by their number: the same for a key whoever asks, in any order. Two rounds of a
/// bijective mixer of multiplications and shifts, each entered with a word of the key.
[[gnu::always_inline]] inline std::uint32_t random_bits(RandomKey key, std::uint32_t number) {
  std::uint32_t bits = number ^ key.first;
  bits = (bits ^ (bits >> 16)) * 0x7FEB352DU;
  bits = (bits ^ (bits >> 15)) * 0x846CA68BU;
  bits = (bits ^ (bits >> 16)) + key.second;
  bits = (bits ^ (bits >> 16)) * 0x7FEB352DU;
  bits = (bits ^ (bits >> 15)) * 0x846CA68BU;
  return bits ^ (bits >> 16);
}

/// In [0, 1).
[[gnu::always_inline]] inline float uniform(std::uint32_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits >> 8U)) * 0x1p-24F;
}

/// Numbers of a standard normal distribution.
struct NormalPair {
  float first = 0.0F;
  float second = 0.0F;
};

/// Two independent standard normal numbers, at most 5.1 off, of random bits (Box and Muller 1958):
/// of 18 bits a radius, of 13 a direction ahead of one's side, of one whether it is behind it.
[[gnu::always_inline]] inline NormalPair normal_pair(std::uint32_t bits) {
  const float share =
      (static_cast<float>(static_cast<std::int32_t>(bits >> 14U)) + 0.5F) * 0x1p-18F;
  const float radius = std::sqrt(-2.0F * log_of(share));
  constexpr float kRadPerStep = std::numbers::pi_v<float> / 8192.0F;
  const float way_rad =
      (static_cast<float>(static_cast<std::int32_t>(bits & 0x1FFFU)) - 4095.5F) * kRadPerStep;
  // Taylor's series within a quarter of a turn, right to 4e-6.
  const float square = way_rad * way_rad;
  const float sine =
      way_rad *
      (1.0F +
       square * (-1.0F / 6.0F + square * (1.0F / 120.0F + square * (-1.0F / 5040.0F +
                                                                    square * (1.0F / 362880.0F)))));
  const float cosine =
      1.0F +
      square *
          (-0.5F + square * (1.0F / 24.0F +
                             square * (-1.0F / 720.0F +
                                       square * (1.0F / 40320.0F - square * (1.0F / 3628800.0F)))));
  return {sign_turned(radius * cosine, bits << 18U), radius * sine};
}

}  // namespace echomap::localization
