// SPDX-License-Identifier: MIT
#include "host/localization/resampling.hpp"

#include <algorithm>
#include <cmath>

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

double unit(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

double sum_of(std::span<const float> weights) {
  double sum = 0.0;
  for (const float weight : weights) {
    sum += static_cast<double>(weight);
  }
  return sum;
}

/// Goes along the weights laid end to end and takes where `count` rising targets fall; `offset()`
/// is within a step, [0, 1).
template <typename Offset>
void draw_by_steps(std::span<const float> weights,
                   double step,
                   std::size_t count,
                   Offset offset,
                   std::vector<std::uint32_t>& ancestors) {
  double up_to = 0.0;
  std::size_t drawn = 0;
  double target = step * offset();
  for (std::uint32_t i = 0; i < weights.size() && drawn < count; ++i) {
    up_to += static_cast<double>(weights[i]);
    while (target < up_to && drawn < count) {
      ancestors.push_back(i);
      ++drawn;
      target = step * (static_cast<double>(drawn) + offset());
    }
  }
  // What rounding has left over goes to the last that has any weight.
  const auto last =
      std::find_if(weights.rbegin(), weights.rend(), [](float w) { return w > 0.0F; });
  ancestors.resize(ancestors.size() + count - drawn,
                   static_cast<std::uint32_t>(weights.rend() - last - 1));
}

void draw_residual(std::span<const float> weights,
                   double step,
                   std::size_t count,
                   std::mt19937& random,
                   std::vector<std::uint32_t>& ancestors) {
  std::vector<float> rests(weights.size());
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    const double share = static_cast<double>(weights[i]) / step;
    const auto whole = std::min(static_cast<std::size_t>(share), count - ancestors.size());
    ancestors.insert(ancestors.end(), whole, i);
    rests[i] = static_cast<float>(share - std::floor(share));
  }
  const double rest = sum_of(rests);
  const std::size_t left = count - ancestors.size();
  if (left > 0 && rest > 0.0) {
    draw_by_steps(
        rests, rest / static_cast<double>(left), left, [&] { return unit(random); }, ancestors);
    std::sort(ancestors.begin(), ancestors.end());
  } else {
    ancestors.resize(count, ancestors.empty() ? 0 : ancestors.back());
  }
}

/// Algorithm 2 of the paper: on from a random place by up to twice the greatest weight.
void draw_by_wheel(std::span<const float> weights,
                   std::size_t count,
                   std::mt19937& random,
                   std::vector<std::uint32_t>& ancestors) {
  const double greatest = static_cast<double>(*std::max_element(weights.begin(), weights.end()));
  auto i = static_cast<std::size_t>(unit(random) * static_cast<double>(weights.size()));
  double beyond = 0.0;
  for (std::size_t drawn = 0; drawn < count; ++drawn) {
    beyond += 2.0 * greatest * unit(random);
    while (beyond > static_cast<double>(weights[i])) {
      beyond -= static_cast<double>(weights[i]);
      i = i + 1 == weights.size() ? 0 : i + 1;
    }
    ancestors.push_back(static_cast<std::uint32_t>(i));
  }
}

ECHOMAP_AVX2_CLONES
void take(const float* __restrict from,
          const std::uint32_t* __restrict ancestors,
          std::size_t count,
          float* __restrict to) {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = from[ancestors[i]];
  }
}

ECHOMAP_AVX2_CLONES
void exponentials(const float* __restrict logs,
                  std::size_t count,
                  float greatest,
                  float* __restrict weights) {
  for (std::size_t i = 0; i < count; ++i) {
    weights[i] = exp_of_negative(logs[i] - greatest);
  }
}

}  // namespace

void draw_ancestors(std::span<const float> weights,
                    std::size_t count,
                    ResamplingScheme scheme,
                    std::mt19937& random,
                    std::vector<std::uint32_t>& ancestors) {
  ancestors.clear();
  ancestors.reserve(count);
  if (count == 0) {
    return;
  }
  const double step = sum_of(weights) / static_cast<double>(count);
  switch (scheme) {
    case ResamplingScheme::kSystematic: {
      const double offset = unit(random);
      draw_by_steps(
          weights, step, count, [=] { return offset; }, ancestors);
      return;
    }
    case ResamplingScheme::kStratified:
      draw_by_steps(
          weights, step, count, [&] { return unit(random); }, ancestors);
      return;
    case ResamplingScheme::kResidual:
      draw_residual(weights, step, count, random, ancestors);
      return;
    case ResamplingScheme::kWheel:
      draw_by_wheel(weights, count, random, ancestors);
      return;
  }
}

void take_ancestors(const Particles& before,
                    std::span<const std::uint32_t> ancestors,
                    Particles& after) {
  after.resize(ancestors.size());
  const std::size_t count = ancestors.size();
  take(before.x_m.data(), ancestors.data(), count, after.x_m.data());
  take(before.y_m.data(), ancestors.data(), count, after.y_m.data());
  take(before.heading_rad.data(), ancestors.data(), count, after.heading_rad.data());
  std::fill(after.log_weight.begin(), after.log_weight.end(), 0.0F);
}

double effective_count(std::span<const float> weights) {
  double sum = 0.0;
  double squares = 0.0;
  for (const float weight : weights) {
    const auto w = static_cast<double>(weight);
    sum += w;
    squares += w * w;
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

void relative_weights(const Particles& particles, std::vector<float>& weights) {
  weights.resize(particles.size());
  if (weights.empty()) {
    return;
  }
  const float greatest =
      *std::max_element(particles.log_weight.begin(), particles.log_weight.end());
  exponentials(particles.log_weight.data(), particles.size(), greatest, weights.data());
}

}  // namespace echomap::localization
