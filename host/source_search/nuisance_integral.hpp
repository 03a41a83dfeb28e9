// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/source_search/leaf_block.hpp"

namespace echomap::source_search {

/// The integral of a likelihood over strength and background, whose logarithms are uniform. A
/// log-likelihood is smooth in the logarithm of the strength, so that cubic interpolation between a
/// few nodes represents it, where the likelihood itself is a narrow peak between them.
class NuisanceIntegral {
 public:
  /// One row to be summed: four nodes of the strength with their weights, and the prior's mass.
  struct Step {
    std::size_t first = 0;  ///< Node of the strength.
    float weights[4] = {};
    float mass = 0.0F;
    float strength = 0.0F;
  };

  /// Takes at least four strengths, and cuts each step between them into `cuts`.
  /// `background_masses` is the prior's mass at each background.
  NuisanceIntegral(const NuisanceNodes& nodes,
                   std::size_t cuts,
                   std::vector<float> background_masses);

  const std::vector<Step>& steps() const { return steps_; }
  const std::vector<float>& background_masses() const { return background_masses_; }

  /// Integral over the strengths for one attenuation and background.
  struct Group {
    alignas(64) Lanes max{};  ///< Of the log-likelihood.
    alignas(64) Lanes sum{};  ///< Of the likelihood over that of the maximum, with prior masses.
  };
  /// Integrates the rows of one attenuation and background.
  Group group(const float* log_likelihood) const;

 private:
  std::vector<Step> steps_;
  std::vector<float> background_masses_;
};

}  // namespace echomap::source_search
