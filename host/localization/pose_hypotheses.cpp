// SPDX-License-Identifier: MIT
#include "host/localization/pose_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/localization/pose_bins.hpp"

namespace echomap::localization {

namespace {

/// Weight, and weighted sums of poses and their products, as seen from a bin's middle.
struct Moments {
  double weight = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

  void add(double w, const Eigen::Vector3d& pose) {
    const Eigen::Vector3d weighted = w * pose;
    weight += w;
    sum += weighted;
    products.noalias() += weighted * pose.transpose();
  }
  /// Others that are seen from a middle which lies at `offset` from ours.
  void add(const Moments& other, const Eigen::Vector3d& offset) {
    const Eigen::Matrix3d cross = other.sum * offset.transpose();
    weight += other.weight;
    sum += other.sum + other.weight * offset;
    products +=
        other.products + cross + cross.transpose() + other.weight * offset * offset.transpose();
  }
};

/// With a heading in [0, 2 pi), as bins have it.
Eigen::Vector3d pose_of(const Particles& particles, std::size_t i) {
  const auto heading_rad = static_cast<double>(particles.heading_rad[i]);
  return {static_cast<double>(particles.x_m[i]),
          static_cast<double>(particles.y_m[i]),
          heading_rad < 0.0 ? heading_rad + 2.0 * std::numbers::pi : heading_rad};
}

Eigen::Vector3d offset_between(const PoseBins& bins, PoseBin from, PoseBin to) {
  Eigen::Vector3d offset = bins.middle(to) - bins.middle(from);
  offset.z() = geometry::wrap_angle(offset.z());
  return offset;
}

/// The heaviest of a bin and its 26 neighbours; of equals that with the lowest number.
std::int32_t heaviest_around(const PoseBins& bins,
                             const std::vector<Moments>& moments,
                             std::int32_t number) {
  std::int32_t best = number;
  for (const std::int32_t other : bins.neighbours(number)) {
    const double ahead = moments[static_cast<std::size_t>(other)].weight -
                         moments[static_cast<std::size_t>(best)].weight;
    if (ahead > 0.0 || (ahead == 0.0 && other < best)) {
      best = other;
    }
  }
  return best;
}

PoseHypothesis hypothesis_of(const Moments& hill, const Eigen::Vector3d& summit, double all) {
  const Eigen::Vector3d mean = hill.sum / hill.weight;
  const Eigen::Vector3d pose = summit + mean;
  return {{pose.x(), pose.y(), geometry::wrap_angle(pose.z())},
          hill.products / hill.weight - mean * mean.transpose(),
          hill.weight / all};
}

}  // namespace

std::vector<PoseHypothesis> find_hypotheses(const Particles& particles,
                                            std::span<const float> weights,
                                            const HypothesisParams& params) {
  PoseBins bins({params.bin_m, params.bin_rad});
  std::vector<Moments> moments;
  double all = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto weight = static_cast<double>(weights[i]);
    if (!(weight > 0.0)) {
      continue;
    }
    const Eigen::Vector3d pose = pose_of(particles, i);
    const PoseBin bin = bins.bin_at(pose);
    const auto number = static_cast<std::size_t>(bins.insert(bin));
    moments.resize(std::max(moments.size(), number + 1));
    moments[number].add(weight, pose - bins.middle(bin));
    all += weight;
  }

  std::vector<std::int32_t> leads_to(moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    leads_to[i] = heaviest_around(bins, moments, static_cast<std::int32_t>(i));
  }
  std::map<std::int32_t, Moments> hills;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    std::int32_t summit = leads_to[i];
    while (leads_to[static_cast<std::size_t>(summit)] != summit) {
      summit = leads_to[static_cast<std::size_t>(summit)];
    }
    const auto number = static_cast<std::int32_t>(i);
    hills[summit].add(moments[i], offset_between(bins, bins.bin(summit), bins.bin(number)));
  }

  std::vector<PoseHypothesis> hypotheses;
  for (const auto& [summit, hill] : hills) {
    hypotheses.push_back(hypothesis_of(hill, bins.middle(bins.bin(summit)), all));
  }
  std::stable_sort(hypotheses.begin(), hypotheses.end(), [](const auto& one, const auto& other) {
    return one.probability > other.probability;
  });
  return hypotheses;
}

}  // namespace echomap::localization
