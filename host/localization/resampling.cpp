// SPDX-License-Identifier: MIT
#include "host/localization/resampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "host/localization/lane_math.hpp"
#include "host/mapping/vector_clones.hpp"
#include "host/models/uniform_sample.hpp"

namespace echomap::localization {

namespace {

using models::uniform_sample;

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

ECHOMAP_VECTOR_CLONES
double sum_of(std::span<const float> weights) {
  return sum_in_lanes(weights, [](double weight) { return weight; });
}

ECHOMAP_VECTOR_CLONES
double sum_of_squares(std::span<const float> weights) {
  return sum_in_lanes(weights, [](double weight) { return weight * weight; });
}

/// Where draws by even steps begin to fall on what lies `up_to` along the weights.
struct EvenSteps {
  double per_step;
  double offset;
  double count;

  [[gnu::always_inline]] std::size_t first_from(double up_to) const {
    // Rounded down after the addition of 1: rounded up, save where it is whole.
    return static_cast<std::size_t>(
        std::min(std::max(up_to * per_step - offset, -0.5) + 1.0, count));
  }
};

/// The draws [first, end) that fall on a block of weights beginning `up_to` along all: a particle's
/// first draw is written down, over those of particles without any; the greatest so far is then the
/// ancestor. No branches.
void draw_block(std::span<const float> weights,
                ParticleRange range,
                double up_to,
                const EvenSteps& steps,
                std::span<std::uint32_t> draws,
                std::size_t first) {
  std::uint32_t beyond = 0;
  std::fill(draws.begin(), draws.end(), 0U);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const std::size_t draw = steps.first_from(up_to) - first;
    (draw < draws.size() ? draws[draw] : beyond) = static_cast<std::uint32_t>(i);
    up_to += static_cast<double>(weights[i]);
  }
  auto greatest = static_cast<std::uint32_t>(range.begin);
  for (std::uint32_t& draw : draws) {
    greatest = std::max(greatest, draw);
    draw = greatest;
  }
}

void draw_systematic(std::span<const float> weights,
                     std::size_t count,
                     double offset,
                     std::vector<std::uint32_t>& ancestors,
                     const Workers& workers) {
  ancestors.resize(count);
  std::vector<double> up_to(blocks_in(weights.size()) + 1);
  share_blocks(workers, weights.size(), [&](ParticleRange range, std::size_t block) {
    up_to[block + 1] = sum_of(weights.subspan(range.begin, range.size()));
  });
  std::partial_sum(up_to.begin(), up_to.end(), up_to.begin());
  const EvenSteps steps{
      static_cast<double>(count) / up_to.back(), offset, static_cast<double>(count)};
  share_blocks(workers, weights.size(), [&](ParticleRange range, std::size_t block) {
    const std::size_t first = steps.first_from(up_to[block]);
    const std::size_t end =
        range.end == weights.size() ? count : steps.first_from(up_to[block + 1]);
    draw_block(weights,
               range,
               up_to[block],
               steps,
               std::span(ancestors).subspan(first, end - first),
               first);
  });
}

/// Algorithm 2 of the paper: on from a random place by up to twice the greatest weight.
void draw_by_wheel(std::span<const float> weights,
                   std::size_t count,
                   std::mt19937& random,
                   std::vector<std::uint32_t>& ancestors) {
  const double greatest = static_cast<double>(*std::max_element(weights.begin(), weights.end()));
  auto i = static_cast<std::size_t>(uniform_sample(random) * static_cast<double>(weights.size()));
  double beyond = 0.0;
  for (std::size_t drawn = 0; drawn < count; ++drawn) {
    beyond += 2.0 * greatest * uniform_sample(random);
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

ECHOMAP_VECTOR_CLONES
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

ECHOMAP_VECTOR_CLONES
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
                    std::vector<std::uint32_t>& ancestors,
                    const Workers& workers) {
  ancestors.clear();
  if (count == 0) {
    return;
  }
  ancestors.reserve(count);
  if (scheme == ResamplingScheme::kSystematic) {
    draw_systematic(weights, count, uniform_sample(random), ancestors, workers);
    return;
  }
  draw_by_wheel(weights, count, random, ancestors);
}

void take_ancestors(const Particles& before,
                    std::span<const std::uint32_t> ancestors,
                    Particles& after,
                    const Workers& workers) {
  after.resize(ancestors.size());
  share_blocks(workers, ancestors.size(), [&](ParticleRange range, std::size_t) {
    const std::uint32_t* const from = &ancestors[range.begin];
    take(before.x_m.data(), from, range.size(), &after.x_m[range.begin]);
    take(before.y_m.data(), from, range.size(), &after.y_m[range.begin]);
    take(before.heading_rad.data(), from, range.size(), &after.heading_rad[range.begin]);
    std::fill_n(&after.log_weight[range.begin], range.size(), 0.0F);
  });
}

double WeightSums::log_total() const { return sum > 0.0 ? log_greatest + std::log(sum) : 0.0; }

double WeightSums::effective_count() const { return squares > 0.0 ? sum * sum / squares : 0.0; }

WeightSums relative_weights(const Particles& particles,
                            std::vector<float>& weights,
                            const Workers& workers) {
  weights.resize(particles.size());
  if (weights.empty()) {
    return {};
  }
  const std::span<const float> logs = particles.log_weight;
  std::vector<WeightSums> blocks(blocks_in(logs.size()));
  share_blocks(workers, logs.size(), [&](ParticleRange range, std::size_t block) {
    blocks[block].log_greatest =
        static_cast<double>(greatest_of(logs.subspan(range.begin, range.size())));
  });
  WeightSums all =
      *std::max_element(blocks.begin(), blocks.end(), [](const auto& a, const auto& b) {
        return a.log_greatest < b.log_greatest;
      });
  share_blocks(workers, logs.size(), [&](ParticleRange range, std::size_t block) {
    const std::span<float> own = std::span(weights).subspan(range.begin, range.size());
    exponentials(&logs[range.begin], own.size(), static_cast<float>(all.log_greatest), own.data());
    blocks[block].sum = sum_of(own);
    blocks[block].squares = sum_of_squares(own);
  });
  for (const WeightSums& block : blocks) {
    all.sum += block.sum;
    all.squares += block.squares;
  }
  return all;
}

}  // namespace echomap::localization
