// SPDX-License-Identifier: MIT
#include "host/localization/resampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

double unit(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

/// Sums in lanes, so that the order of additions is the same on every processor.
template <typename Term>
[[gnu::always_inline]] inline double sum_in_lanes(std::span<const float> weights, Term term) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> lanes{};
  const std::size_t whole = weights.size() / kLanes * kLanes;
  for (std::size_t begin = 0; begin < whole; begin += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes[lane] += term(static_cast<double>(weights[begin + lane]));
    }
  }
  for (std::size_t i = whole; i < weights.size(); ++i) {
    lanes[i - whole] += term(static_cast<double>(weights[i]));
  }
  return std::accumulate(lanes.begin(), lanes.end(), 0.0);
}

ECHOMAP_AVX2_CLONES
double sum_of(std::span<const float> weights) {
  return sum_in_lanes(weights, [](double weight) { return weight; });
}

ECHOMAP_AVX2_CLONES
double sum_of_squares(std::span<const float> weights) {
  return sum_in_lanes(weights, [](double weight) { return weight * weight; });
}

/// A particle's first draw is written down, over those of particles without any; the greatest so
/// far is then the ancestor. No branches.
void draw_systematic(std::span<const float> weights,
                     double step,
                     std::size_t count,
                     double offset,
                     std::vector<std::uint32_t>& ancestors) {
  ancestors.assign(count + 1, 0);
  const double per_step = 1.0 / step;
  const auto most = static_cast<double>(count);
  double up_to = 0.0;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    const double first = std::min(std::max(up_to * per_step - offset, -0.5) + 1.0, most);
    // Rounded down after the addition of 1: rounded up, save where it is whole.
    ancestors[static_cast<std::size_t>(first)] = i;
    up_to += static_cast<double>(weights[i]);
  }
  ancestors.resize(count);
  std::uint32_t greatest = 0;
  for (std::uint32_t& ancestor : ancestors) {
    greatest = std::max(greatest, ancestor);
    ancestor = greatest;
  }
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
float greatest_of(std::span<const float> values) {
  constexpr std::size_t kLanes = 16;
  std::array<float, kLanes> lanes;
  lanes.fill(values.front());
  const std::size_t whole = values.size() / kLanes * kLanes;
  for (std::size_t begin = 0; begin < whole; begin += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float value = values[begin + lane];
      lanes[lane] = value > lanes[lane] ? value : lanes[lane];
    }
  }
  const float greatest = *std::max_element(lanes.begin(), lanes.end());
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(whole),
                         values.end(),
                         greatest,
                         [](float one, float other) { return std::max(one, other); });
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
    case ResamplingScheme::kSystematic:
      draw_systematic(weights, step, count, unit(random), ancestors);
      return;
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
  const double sum = sum_of(weights);
  const double squares = sum_of_squares(weights);
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

void relative_weights(const Particles& particles, std::vector<float>& weights) {
  weights.resize(particles.size());
  if (weights.empty()) {
    return;
  }
  const float greatest = greatest_of(particles.log_weight);
  exponentials(particles.log_weight.data(), particles.size(), greatest, weights.data());
}

}  // namespace echomap::localization
