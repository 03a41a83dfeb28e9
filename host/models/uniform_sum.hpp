// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::models {

/// sample_normal_distribution of Mukherjee et al., section V-A:
///
///     sample(b) = b / 6 times the sum of 12 even draws from (-1, 1).
///
/// Each draw has the variance 1/3, the sum 4 and so the deviation 2: sample(b) deviates by b / 3
/// and never by more than 2 b. The paper calls b the variance; it is neither that nor the
/// deviation. `Uniform` gives a number in [0, 1) a call.
template <typename Uniform>
double uniform_sum_sample(double b, Uniform&& uniform) {
  double sum = 0.0;
  for (int i = 0; i < 12; ++i) {
    sum += 2.0 * uniform() - 1.0;
  }
  return b / 6.0 * sum;
}

/// The standard deviation of `uniform_sum_sample`.
constexpr double uniform_sum_stddev(double b) { return b / 3.0; }

/// The `b` of a sample with that standard deviation.
constexpr double uniform_sum_b(double std_dev) { return 3.0 * std_dev; }

}  // namespace echomap::models
