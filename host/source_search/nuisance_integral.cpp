// SPDX-License-Identifier: MIT
#include "host/source_search/nuisance_integral.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::source_search {

namespace {

using Step = NuisanceIntegral::Step;

/// Lagrange's weights of the nodes 0, 1, 2, 3 at a place between them.
void set_weights(Step& step, double at) {
  for (int i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (int j = 0; j < 4; ++j) {
      weight *= j == i ? 1.0 : (at - j) / (i - j);
    }
    step.weights[i] = static_cast<float>(weight);
  }
}

ECHOMAP_VECTOR_CLONES
void interpolate(const float* __restrict rows,
                 const Step& step,
                 float* __restrict values,
                 float* __restrict max) {
  const float* from = rows + step.first * kLanes;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float value = step.weights[0] * from[i] + step.weights[1] * from[kLanes + i] +
                        step.weights[2] * from[2 * kLanes + i] +
                        step.weights[3] * from[3 * kLanes + i];
    values[i] = value;
    max[i] = max[i] < value ? value : max[i];
  }
}

ECHOMAP_VECTOR_CLONES
void add_exponentials(const float* __restrict values,
                      const float* __restrict max,
                      float mass,
                      float* __restrict sum) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    sum[i] += mass * localization::exp_of_negative(values[i] - max[i]);
  }
}

}  // namespace

NuisanceIntegral::NuisanceIntegral(const NuisanceNodes& nodes,
                                   std::size_t cuts,
                                   std::vector<float> background_masses)
    : background_masses_(std::move(background_masses)) {
  const std::size_t count = nodes.strengths.size();
  const std::size_t last = (count - 1) * cuts;
  const double log_first = std::log(nodes.strengths.front());
  const double log_range = std::log(nodes.strengths.back()) - log_first;
  for (std::size_t i = 0; i <= last; ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(cuts);
    const std::size_t before = i / cuts;
    Step step;
    step.first = std::clamp<std::size_t>(before, 1, count - 3) - 1;
    set_weights(step, at - static_cast<double>(step.first));
    const double share = i == 0 || i == last ? 0.5 : 1.0;
    step.mass = static_cast<float>(share / static_cast<double>(last));
    step.strength = static_cast<float>(
        std::exp(log_first + log_range * static_cast<double>(i) / static_cast<double>(last)));
    steps_.push_back(step);
  }
}

NuisanceIntegral::Group NuisanceIntegral::group(const float* log_likelihood) const {
  Group group;
  group.max.fill(-1e30F);
  std::vector<Lanes> values(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    interpolate(log_likelihood, steps_[i], values[i].data(), group.max.data());
  }
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    add_exponentials(values[i].data(), group.max.data(), steps_[i].mass, group.sum.data());
  }
  return group;
}

}  // namespace echomap::source_search
