// SPDX-License-Identifier: MIT
#include "host/slam/mean_turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace echomap::slam {

TurnEstimate mean_turn(const std::vector<double>& log_likelihoods, double step_rad) {
  const double most = *std::max_element(log_likelihoods.begin(), log_likelihoods.end());
  const double middle = 0.5 * static_cast<double>(log_likelihoods.size() - 1);
  double weights = 0.0;
  double sum_rad = 0.0;
  double squares_rad2 = 0.0;
  for (std::size_t i = 0; i < log_likelihoods.size(); ++i) {
    const double weight = std::exp(log_likelihoods[i] - most);
    const double turn_rad = (static_cast<double>(i) - middle) * step_rad;
    weights += weight;
    sum_rad += weight * turn_rad;
    squares_rad2 += weight * turn_rad * turn_rad;
  }
  const double mean_rad = sum_rad / weights;
  const double variance_rad2 = squares_rad2 / weights - mean_rad * mean_rad;
  return {mean_rad, std::max(std::sqrt(std::max(0.0, variance_rad2)), 0.5 * step_rad)};
}

}  // namespace echomap::slam
