// SPDX-License-Identifier: MIT
#include "host/source_search/block_posterior.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::source_search {

namespace {

constexpr std::size_t kMaxCuts = 8;
/// A likelihood is summed in steps of so many of its standard deviations.
constexpr double kStddevsPerStep = 1.0;

/// The information about the logarithm of a strength is no more than the pulses that were counted.
double information_of(const HypothesisGrid& grid) {
  const FieldParams& field = grid.params().field;
  double information = 0.0;
  for (const FieldReading& reading : grid.readings()) {
    const double error = reading.value / field.level_stddev;
    information += field.kind == SensorKind::kPulses ? reading.value : error * error;
  }
  return information;
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

NuisanceIntegral integral_for(const HypothesisGrid& grid) {
  const NuisanceNodes& nodes = grid.nodes();
  const double step = std::log(static_cast<double>(nodes.strengths[1] / nodes.strengths[0]));
  const double cuts = std::ceil(step * std::sqrt(information_of(grid)) / kStddevsPerStep);
  const std::size_t backgrounds = nodes.backgrounds.size();
  std::vector<float> masses(backgrounds, 1.0F / static_cast<float>(backgrounds - 1));
  masses.front() *= 0.5F;
  masses.back() *= 0.5F;
  return NuisanceIntegral(
      nodes, static_cast<std::size_t>(std::clamp(cuts, 1.0, double{kMaxCuts})), std::move(masses));
}

BlockPosterior posterior_of(const HypothesisGrid& grid,
                            const NuisanceIntegral& integral,
                            const LeafBlock& block,
                            double density,
                            double reference) {
  const NuisanceNodes& nodes = grid.nodes();
  const std::size_t attenuations = nodes.attenuations_per_m.size();
  const std::size_t backgrounds = nodes.backgrounds.size();
  BlockPosterior posterior;
  posterior.background.assign(backgrounds, 0.0);
  for (std::size_t g = 0; g < attenuations * backgrounds; ++g) {
    const std::size_t b = g % backgrounds;
    const auto group = integral.group(block.lanes(g * nodes.strengths.size()));
    const double mass = density * static_cast<double>(integral.background_masses()[b]) /
                        static_cast<double>(attenuations);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const double probability = mass * block.area_m2[i] * static_cast<double>(group.sum[i]) *
                                 std::exp(static_cast<double>(group.max[i]) - reference);
      posterior.place[i] += probability;
      posterior.background[b] += probability;
    }
  }
  return posterior;
}

std::vector<NuisanceShare> nuisances_of(const HypothesisGrid& grid,
                                        const NuisanceIntegral& integral,
                                        LeafIndex leaf) {
  const NuisanceNodes& nodes = grid.nodes();
  const LeafBlock& block = grid.blocks()[leaf.block];
  std::vector<NuisanceShare> shares;
  std::size_t node = 0;
  for (const float attenuation_per_m : nodes.attenuations_per_m) {
    for (std::size_t b = 0; b < nodes.backgrounds.size(); ++b) {
      for (const NuisanceIntegral::Step& step : integral.steps()) {
        const double mass = static_cast<double>(integral.background_masses()[b] * step.mass);
        shares.push_back({interpolated(block.lanes(node), step, leaf.lane) + std::log(mass),
                          static_cast<double>(step.strength),
                          static_cast<double>(nodes.backgrounds[b]),
                          static_cast<double>(attenuation_per_m)});
      }
      node += nodes.strengths.size();
    }
  }
  normalize(shares);
  return shares;
}

}  // namespace echomap::source_search
