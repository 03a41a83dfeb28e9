// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

namespace echomap::optimization {

/// Repeats the steps of Gauss and Newton: `linearize()` answers the normal equations at the present
/// estimate (NormalEquations or BlockEquations), `apply(step)` moves the estimate and answers
/// whether it has converged. False where the equations do not determine a step: the estimate stays
/// where it was then.
template <class Linearize, class Apply>
bool gauss_newton(int max_iterations, Linearize&& linearize, Apply&& apply) {
  for (int i = 0; i < max_iterations; ++i) {
    const auto step = linearize().solve();
    if (!step) {
      return false;
    }
    if (apply(*step)) {
      break;
    }
  }
  return true;
}

}  // namespace echomap::optimization
