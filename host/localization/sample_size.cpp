// SPDX-License-Identifier: MIT
#include "host/localization/sample_size.hpp"

#include <cmath>

namespace echomap::localization {

std::size_t kld_sample_size(std::size_t occupied_bins, double max_error) {
  if (occupied_bins < 2) {
    return 1;
  }
  constexpr double kUpper99 = 2.3263;  // Of the standard normal distribution.
  const auto others = static_cast<double>(occupied_bins - 1);
  const double ninth = 2.0 / (9.0 * others);
  const double root = 1.0 - ninth + std::sqrt(ninth) * kUpper99;
  return static_cast<std::size_t>(std::ceil(others / (2.0 * max_error) * root * root * root));
}

}  // namespace echomap::localization
