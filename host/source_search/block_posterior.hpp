// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/source_search/hypothesis_grid.hpp"
#include "host/source_search/nuisance_integral.hpp"

namespace echomap::source_search {

/// Integral over the nuisance parameters that is fine enough for a block: where its likelihoods are
/// narrow in the strength, that is cut into more steps.
NuisanceIntegral integral_for(const HypothesisGrid& grid, const LeafBlock& block);

/// Posteriors of a block, as likelihoods over exp(reference), not normalized.
struct BlockPosterior {
  std::array<double, kLanes> place{};
  std::vector<double> background;  ///< Over all places of the block.
};

/// Computes the posterior of a block, with a prior of `density` per square metre.
BlockPosterior posterior_of(const HypothesisGrid& grid,
                            const LeafBlock& block,
                            double density,
                            double reference);

/// Nuisance parameters that a place is combined with, and their probability there.
struct NuisanceShare {
  double probability = 0.0;
  double strength = 0.0;
  double background = 0.0;
  Shielding shielding;
};

/// All combinations of nuisance parameters of a place.
std::vector<NuisanceShare> nuisances_of(const HypothesisGrid& grid, LeafIndex leaf);

/// Prior mass of each background of a grid.
std::vector<float> background_masses(const HypothesisGrid& grid);

}  // namespace echomap::source_search
