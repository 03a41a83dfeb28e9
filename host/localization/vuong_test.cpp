// SPDX-License-Identifier: MIT
#include "host/localization/vuong_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>

#include "host/geometry/square.hpp"

namespace echomap::localization {
namespace {

/// Of a standard normal variable: the probability that it is above `z`.
double tail(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

}  // namespace

double vuong_statistic(std::span<const double> better, std::span<const double> worse) {
  // Two places that look the same differ by next to nothing, but everywhere.
  constexpr double kMinDeviation = 0.05;
  const auto count = static_cast<double>(better.size());
  const double mean =
      std::inner_product(
          better.begin(), better.end(), worse.begin(), 0.0, std::plus<>(), std::minus<>()) /
      count;
  double squares = 0.0;
  for (std::size_t i = 0; i < better.size(); ++i) {
    squares += geometry::square(better[i] - worse[i] - mean);
  }
  const double deviation = std::sqrt(squares / std::max(1.0, count - 1.0)) + kMinDeviation;
  return mean / (deviation / std::sqrt(count));
}

double odds_of_worse(double deviations) {
  constexpr double kMaxDeviations = 8.0;
  const double z = std::clamp(deviations, -kMaxDeviations, kMaxDeviations);
  return tail(z) / tail(-z);
}

}  // namespace echomap::localization
