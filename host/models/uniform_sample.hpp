// SPDX-License-Identifier: MIT
#pragma once

#include <random>

namespace echomap::models {

/// A sample of the uniform distribution over [0, 1): the generator's 32 bits as a fraction, the
/// same on every machine.
inline double uniform_sample(std::mt19937& random) {
  return static_cast<double>(random()) * 0x1p-32;
}

}  // namespace echomap::models
