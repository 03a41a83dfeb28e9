// SPDX-License-Identifier: MIT
#include "host/localization/pose_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>

#include "host/geometry/angle.hpp"
#include "host/localization/pose_bins.hpp"

namespace echomap::localization {

namespace {

/// Weight, and weighted sums of poses and their products, as seen from a bin's middle.
struct Moments {
  double weight = 0.0;
  double x = 0.0, y = 0.0, h = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0, xh = 0.0, yh = 0.0, hh = 0.0;

  void add(double w, double dx, double dy, double dh) {
    weight += w;
    x += w * dx;
    y += w * dy;
    h += w * dh;
    xx += w * dx * dx;
    xy += w * dx * dy;
    yy += w * dy * dy;
    xh += w * dx * dh;
    yh += w * dy * dh;
    hh += w * dh * dh;
  }
};

/// The same as vectors, for the sums of bins.
struct Hill {
  double weight = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

  /// Moments that are seen from a middle which lies at `offset` from ours.
  void add(const Moments& m, const Eigen::Vector3d& offset) {
    const Eigen::Vector3d sums(m.x, m.y, m.h);
    Eigen::Matrix3d own;
    own << m.xx, m.xy, m.xh, m.xy, m.yy, m.yh, m.xh, m.yh, m.hh;
    const Eigen::Matrix3d cross = sums * offset.transpose();
    weight += m.weight;
    sum += sums + m.weight * offset;
    products += own + cross + cross.transpose() + m.weight * offset * offset.transpose();
  }
};

Eigen::Vector3d offset_between(const PoseBins& bins, PoseBin from, PoseBin to) {
  Eigen::Vector3d offset = bins.middle(to) - bins.middle(from);
  offset.z() = geometry::wrap_angle(offset.z());
  return offset;
}

PoseHypothesis hypothesis_of(const Hill& hill, const Eigen::Vector3d& summit, double all) {
  const Eigen::Vector3d mean = hill.sum / hill.weight;
  const Eigen::Vector3d pose = summit + mean;
  return {{pose.x(), pose.y(), geometry::wrap_angle(pose.z())},
          hill.products / hill.weight - mean * mean.transpose(),
          hill.weight / all};
}

/// Puts all particles with weight into bins; returns their moments by the numbers of the bins.
std::vector<Moments> fill(const Particles& particles,
                          std::span<const float> weights,
                          PoseBins& bins) {
  std::vector<Moments> moments;
  PoseBin last;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::size_t number = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!(weights[i] > 0.0F)) {
      continue;
    }
    const float heading_rad = particles.heading_rad[i];
    const auto x_m = static_cast<double>(particles.x_m[i]);
    const auto y_m = static_cast<double>(particles.y_m[i]);
    const auto turned_rad =
        static_cast<double>(heading_rad) + (heading_rad < 0.0F ? 2.0 * std::numbers::pi : 0.0);
    const PoseBin bin = bins.bin_at(x_m, y_m, turned_rad);
    if (moments.empty() || bin != last) {  // Neighbours in the list are often neighbours in place.
      last = bin;
      middle = bins.middle(bin);
      number = static_cast<std::size_t>(bins.insert(bin));
      moments.resize(bins.size());
    }
    moments[number].add(static_cast<double>(weights[i]),
                        x_m - middle.x(),
                        y_m - middle.y(),
                        turned_rad - middle.z());
  }
  return moments;
}

/// The number of the summit that each bin leads to, always on to the heaviest bin around; of equals
/// to that with the lowest number.
std::vector<std::int32_t> summits(const PoseBins& bins, const std::vector<Moments>& moments) {
  std::vector<std::int32_t> leads_to(moments.size());
  std::iota(leads_to.begin(), leads_to.end(), 0);
  const auto weight = [&](std::int32_t number) {
    return moments[static_cast<std::size_t>(number)].weight;
  };
  const auto lead = [&](std::int32_t from, std::int32_t to) {
    std::int32_t& best = leads_to[static_cast<std::size_t>(from)];
    const double ahead = weight(to) - weight(best);
    if (ahead > 0.0 || (ahead == 0.0 && to < best)) {
      best = to;
    }
  };
  bins.for_neighbours([&](std::int32_t one, std::int32_t other) {
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
                                            const HypothesisParams& params) {
  PoseBins bins({params.bin_m, params.bin_rad});
  const std::vector<Moments> moments = fill(particles, weights, bins);
  const std::vector<std::int32_t> leads_to = summits(bins, moments);
  std::map<std::int32_t, Hill> hills;
  double all = 0.0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const PoseBin bin = bins.bin(static_cast<std::int32_t>(i));
    hills[leads_to[i]].add(moments[i], offset_between(bins, bins.bin(leads_to[i]), bin));
    all += moments[i].weight;
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
