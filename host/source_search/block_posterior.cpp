// SPDX-License-Identifier: MIT
#include "host/source_search/block_posterior.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::source_search {

namespace {

constexpr float kMaxCuts = 8.0F;
/// A likelihood is summed in steps of so many of its standard deviations.
constexpr float kStddevsPerStep = 1.0F;

/// A likelihood that is so much below the largest one at its place, by logarithm, needs no steps.
constexpr float kNearMax = 12.0F;

/// The largest curvature, by node, of a log-likelihood over the strength where it is large.
float max_curvature(const LeafBlock& block, const NuisanceNodes& nodes) {
  const Lanes max = row_maxima(block.lanes(0), nodes.size());
  float curvature = 0.0F;
  for (std::size_t node = 0; node < nodes.size(); node += nodes.strengths.size()) {
    curvature =
        std::max(curvature, max_bend(block.lanes(node), nodes.strengths.size(), max, kNearMax));
  }
  return curvature;
}

/// Of the nodes of a group, by step of the integral, at one lane.
double interpolated(const float* rows, const NuisanceIntegral::Step& step, std::size_t lane) {
  double value = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    value += static_cast<double>(step.weights[i] * rows[(step.first + i) * kLanes + lane]);
  }
  return value;
}

void normalize(std::vector<NuisanceShare>& shares) {
  double max = -1e300;
  for (const NuisanceShare& share : shares) {
    max = std::max(max, share.probability);
  }
  double sum = 0.0;
  for (NuisanceShare& share : shares) {
    share.probability = std::exp(share.probability - max);
    sum += share.probability;
  }
  for (NuisanceShare& share : shares) {
    share.probability /= sum;
  }
}

}  // namespace

std::vector<float> background_masses(const HypothesisGrid& grid) {
  const std::size_t backgrounds = grid.nodes().backgrounds.size();
  std::vector<float> masses(backgrounds, 1.0F / static_cast<float>(backgrounds - 1));
  masses.front() *= 0.5F;
  masses.back() *= 0.5F;
  return masses;
}

NuisanceIntegral integral_for(const HypothesisGrid& grid, const LeafBlock& block) {
  const float cuts = std::ceil(std::sqrt(max_curvature(block, grid.nodes())) / kStddevsPerStep);
  return NuisanceIntegral(grid.nodes(),
                          static_cast<std::size_t>(std::clamp(cuts, 1.0F, kMaxCuts)),
                          background_masses(grid));
}

BlockPosterior posterior_of(const HypothesisGrid& grid,
                            const LeafBlock& block,
                            double density,
                            double reference) {
  const NuisanceNodes& nodes = grid.nodes();
  const NuisanceIntegral integral = integral_for(grid, block);
  const std::size_t backgrounds = nodes.backgrounds.size();
  BlockPosterior posterior;
  posterior.background.assign(backgrounds, 0.0);
  for (std::size_t g = 0; g < nodes.shieldings.size() * backgrounds; ++g) {
    const std::size_t b = g % backgrounds;
    const auto group = integral.group(block.lanes(g * nodes.strengths.size()));
    const double mass = density * static_cast<double>(integral.background_masses()[b]) *
                        nodes.shieldings[g / backgrounds].prior;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const double probability = mass * block.area_m2[i] * static_cast<double>(group.sum[i]) *
                                 std::exp(static_cast<double>(group.max[i]) - reference);
      posterior.place[i] += probability;
      posterior.background[b] += probability;
    }
  }
  return posterior;
}

std::vector<NuisanceShare> nuisances_of(const HypothesisGrid& grid, LeafIndex leaf) {
  const NuisanceNodes& nodes = grid.nodes();
  const LeafBlock& block = grid.blocks()[leaf.block];
  const NuisanceIntegral integral = integral_for(grid, block);
  std::vector<NuisanceShare> shares;
  std::size_t node = 0;
  for (const Shielding& shielding : nodes.shieldings) {
    for (std::size_t b = 0; b < nodes.backgrounds.size(); ++b) {
      for (const NuisanceIntegral::Step& step : integral.steps()) {
        const double mass =
            shielding.prior * static_cast<double>(integral.background_masses()[b] * step.mass);
        shares.push_back({interpolated(block.lanes(node), step, leaf.lane) + std::log(mass),
                          static_cast<double>(step.strength),
                          static_cast<double>(nodes.backgrounds[b]),
                          shielding});
      }
      node += nodes.strengths.size();
    }
  }
  normalize(shares);
  return shares;
}

}  // namespace echomap::source_search
