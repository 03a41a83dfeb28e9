// SPDX-License-Identifier: MIT
#include "host/localization/pose_hypotheses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "host/geometry/angle.hpp"
#include "host/localization/pose_bins.hpp"

namespace echomap::localization {

namespace {

/// Weighted sums of the products of (1, x, y, heading) with each other, row by row: a weight, a sum
/// and second moments. In bins, as seen from a bin's middle.
struct Moments {
  alignas(64) std::array<double, 16> sums{};

  double weight() const { return sums[0]; }

  [[gnu::always_inline]] void add(float weight, float x, float y, float heading) {
    const auto w = static_cast<double>(weight);
    const std::array<double, 4> place{
        1.0, static_cast<double>(x), static_cast<double>(y), static_cast<double>(heading)};
    for (std::size_t row = 0; row < 4; ++row) {
      const double weighted = w * place[row];
      for (std::size_t column = 0; column < 4; ++column) {
        sums[4 * row + column] += weighted * place[column];
      }
    }
  }

  void add(const Moments& other) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += other.sums[i];
    }
  }

  /// Moments that are seen from a middle which lies at `offset` from ours.
  void add(const Moments& other, const std::array<std::int32_t, 3>& offset) {
    const std::array<double, 4> shift{0.0,
                                      static_cast<double>(offset[0]),
                                      static_cast<double>(offset[1]),
                                      static_cast<double>(offset[2])};
    const auto& from = other.sums;
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        sums[4 * row + column] += from[4 * row + column] + from[4 * row] * shift[column] +
                                  shift[row] * (from[column] + from[0] * shift[column]);
      }
    }
  }
};

/// Bins, and the moments of what lies in each by their numbers.
struct FilledBins {
  PoseBins bins;
  std::vector<Moments> moments;

  Moments& at(PoseBin bin) {
    const auto number = static_cast<std::size_t>(bins.insert(bin));
    if (number == moments.size()) {
      moments.emplace_back();
    }
    return moments[number];
  }
};

PoseHypothesis hypothesis_of(const Moments& hill,
                             const PoseBins& bins,
                             PoseBin summit,
                             double all) {
  const Eigen::Matrix4d products = Eigen::Map<const Eigen::Matrix4d>(hill.sums.data());
  const Eigen::Vector3d size = bins.size_of_bin();
  const Eigen::Vector3d mean = products.block<3, 1>(1, 0) / hill.weight();
  const Eigen::Matrix3d spread =
      products.block<3, 3>(1, 1) / hill.weight() - mean * mean.transpose();
  const Eigen::Vector3d pose = bins.middle(summit) + size.cwiseProduct(mean);
  return {{pose.x(), pose.y(), geometry::wrap_angle(pose.z())},
          size.asDiagonal() * spread * size.asDiagonal(),
          hill.weight() / all};
}

/// Puts particles with weight into bins.
void fill(const Particles& particles,
          std::span<const float> weights,
          ParticleRange range,
          FilledBins& filled) {
  BinnedStretch stretch;
  for (std::size_t begin = range.begin; begin < range.end; begin += BinnedStretch::kMost) {
    const std::size_t count = std::min(BinnedStretch::kMost, range.end - begin);
    filled.bins.locate(particles, {begin, begin + count}, stretch);
    for (std::size_t i = 0; i < count; ++i) {
      const float weight = weights[begin + i];
      if (weight > 0.0F) {
        filled.at(stretch.bin(i))
            .add(weight, stretch.off_x[i], stretch.off_y[i], stretch.off_heading[i]);
      }
    }
  }
}

/// In as many parts as the particles are worth, side by side, and then together in their order.
FilledBins fill_in_parts(const Particles& particles,
                         std::span<const float> weights,
                         const PoseBinSize& size,
                         const Workers& workers) {
  constexpr std::size_t kMinPart = 2500;
  constexpr std::size_t kMaxParts = 16;
  const std::size_t count = particles.size();
  const std::size_t parts = std::clamp<std::size_t>(count / kMinPart, 1, kMaxParts);
  std::vector<FilledBins> filled(parts, {PoseBins(size), {}});
  workers.share(parts, [&](std::size_t part) {
    fill(particles, weights, {part * count / parts, (part + 1) * count / parts}, filled[part]);
  });
  FilledBins all = std::move(filled.front());
  for (std::size_t part = 1; part < parts; ++part) {
    for (std::size_t i = 0; i < filled[part].moments.size(); ++i) {
      all.at(filled[part].bins.bin(static_cast<std::int32_t>(i))).add(filled[part].moments[i]);
    }
  }
  return all;
}

/// The number of the summit that each bin leads to, always on to the heaviest bin around; of equals
/// to that with the lowest number.
std::vector<std::int32_t> summits(const FilledBins& filled) {
  std::vector<std::int32_t> leads_to(filled.moments.size());
  std::iota(leads_to.begin(), leads_to.end(), 0);
  const auto weight = [&](std::int32_t number) {
    return filled.moments[static_cast<std::size_t>(number)].weight();
  };
  const auto lead = [&](std::int32_t from, std::int32_t to) {
    std::int32_t& best = leads_to[static_cast<std::size_t>(from)];
    const double ahead = weight(to) - weight(best);
    if (ahead > 0.0 || (ahead == 0.0 && to < best)) {
      best = to;
    }
  };
  filled.bins.for_neighbours([&](std::int32_t one, std::int32_t other) {
    lead(one, other);
    lead(other, one);
  });
  for (std::int32_t& summit : leads_to) {
    while (leads_to[static_cast<std::size_t>(summit)] != summit) {
      summit = leads_to[static_cast<std::size_t>(summit)];
    }
  }
  return leads_to;
}

}  // namespace

std::vector<PoseHypothesis> find_hypotheses(const Particles& particles,
                                            std::span<const float> weights,
                                            const HypothesisParams& params,
                                            const Workers& workers) {
  const FilledBins filled =
      fill_in_parts(particles, weights, {params.bin_m, params.bin_rad}, workers);
  const std::vector<std::int32_t> leads_to = summits(filled);
  std::vector<Moments> hills = filled.moments;
  double all = 0.0;
  for (std::size_t i = 0; i < hills.size(); ++i) {
    const auto number = static_cast<std::int32_t>(i);
    all += filled.moments[i].weight();
    if (leads_to[i] != number) {
      hills[static_cast<std::size_t>(leads_to[i])].add(
          filled.moments[i],
          filled.bins.offset(filled.bins.bin(leads_to[i]), filled.bins.bin(number)));
    }
  }

  std::vector<PoseHypothesis> hypotheses;
  for (std::size_t i = 0; i < hills.size(); ++i) {
    const auto number = static_cast<std::int32_t>(i);
    if (leads_to[i] == number) {
      hypotheses.push_back(hypothesis_of(hills[i], filled.bins, filled.bins.bin(number), all));
    }
  }
  std::stable_sort(hypotheses.begin(), hypotheses.end(), [](const auto& one, const auto& other) {
    return one.probability > other.probability;
  });
  return hypotheses;
}

}  // namespace echomap::localization
