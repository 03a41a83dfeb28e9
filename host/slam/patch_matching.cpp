// SPDX-License-Identifier: MIT
#include "host/slam/patch_matching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

struct PlacedPatch {
  PatchIndex index;
  Eigen::Vector2d point_m;
  double normal_rad = 0.0;
};

PlacedPatch placed(const PlacedPatches& multiscan, PatchIndex index) {
  const SurfacePatch& patch = multiscan.patches[index.patch];
  return {index,
          multiscan.T_map_begin * patch.point_m,
          geometry::wrap_angle(multiscan.T_map_begin.heading_rad() + patch.normal_rad)};
}

/// Patches by the square of the map that they lie in.
class PatchCells {
 public:
  explicit PatchCells(double edge_m) : edge_m_(edge_m) {}

  void add(const PlacedPatch& patch) {
    cells_[key(whole(patch.point_m.x()), whole(patch.point_m.y()))].push_back(patch);
  }

  /// Calls `visit` for the patches of the square that holds the point and of the eight around it.
  template <class Visit>
  void visit_near(const Eigen::Vector2d& point_m, const Visit& visit) const {
    for (std::int64_t x = whole(point_m.x()) - 1; x <= whole(point_m.x()) + 1; ++x) {
      for (std::int64_t y = whole(point_m.y()) - 1; y <= whole(point_m.y()) + 1; ++y) {
        const auto cell = cells_.find(key(x, y));
        if (cell != cells_.end()) {
          std::for_each(cell->second.begin(), cell->second.end(), visit);
        }
      }
    }
  }

 private:
  std::int64_t whole(double coordinate_m) const {
    return static_cast<std::int64_t>(std::floor(coordinate_m / edge_m_));
  }
  static std::int64_t key(std::int64_t x, std::int64_t y) {
    return x * (std::int64_t{1} << 32U) + y;
  }

  double edge_m_;
  std::unordered_map<std::int64_t, std::vector<PlacedPatch>> cells_;
};

struct Candidate {
  std::size_t patch = 0;
  double squares_m2 = 0.0;
};
/// The nearest patch of each multiscan, in the order of time.
using Candidates = std::map<std::size_t, Candidate>;

class PartnerSearch {
 public:
  PartnerSearch(const PatchCells& cells, const PatchMatchingParams& params)
      : cells_(cells), params_(params) {}

  void append_partners(const PlacedPatch& patch, std::vector<PatchMatch>& matches) const {
    const Candidates candidates = candidates_of(patch);
    std::vector<PatchIndex> visit;
    std::vector<PatchIndex> revisits;
    for (const auto& [multiscan, candidate] : candidates) {
      (is_revisit(patch.index.multiscan, multiscan) ? revisits : visit)
          .push_back({multiscan, candidate.patch});
    }
    const std::size_t latest = std::min(visit.size(), params_.most_partners);
    for (std::size_t i = visit.size() - latest; i < visit.size(); ++i) {
      matches.push_back({patch.index, visit[i], false});
    }
    const std::size_t spread = std::min(revisits.size(), params_.most_partners);
    for (std::size_t i = 0; i < spread; ++i) {
      matches.push_back({patch.index, revisits[i * revisits.size() / spread], true});
    }
  }

 private:
  bool is_revisit(std::size_t later, std::size_t earlier) const {
    return later - earlier > params_.visit_multiscans;
  }

  Candidates candidates_of(const PlacedPatch& patch) const {
    Candidates candidates;
    cells_.visit_near(patch.point_m, [&](const PlacedPatch& other) {
      if (other.index.multiscan >= patch.index.multiscan || !may_be_one(patch, other)) {
        return;
      }
      const double squares_m2 = (patch.point_m - other.point_m).squaredNorm();
      const auto [found, is_new] =
          candidates.try_emplace(other.index.multiscan, Candidate{other.index.patch, squares_m2});
      if (!is_new && squares_m2 < found->second.squares_m2) {
        found->second = {other.index.patch, squares_m2};
      }
    });
    return candidates;
  }

  bool may_be_one(const PlacedPatch& patch, const PlacedPatch& other) const {
    const Eigen::Vector2d normal = geometry::unit_vector(other.normal_rad);
    const Eigen::Vector2d apart_m = patch.point_m - other.point_m;
    const double across_m = std::abs(normal.dot(apart_m));
    const double along_m = std::abs(normal.x() * apart_m.y() - normal.y() * apart_m.x());
    const bool is_old = is_revisit(patch.index.multiscan, other.index.multiscan);
    return along_m <= params_.along_m &&
           across_m <= (is_old ? params_.revisit_across_m : params_.across_m) &&
           std::abs(geometry::angle_between(other.normal_rad, patch.normal_rad)) <=
               params_.most_angle_rad;
  }

  const PatchCells& cells_;
  const PatchMatchingParams& params_;
};

double reach_m(const PatchMatchingParams& params) {
  return std::hypot(params.along_m, std::max(params.across_m, params.revisit_across_m));
}

}  // namespace

std::vector<PatchMatch> match_patches(const std::vector<PlacedPatches>& multiscans,
                                      std::size_t first,
                                      const PatchMatchingParams& params) {
  PatchCells cells(reach_m(params));
  for (std::size_t i = 0; i < multiscans.size(); ++i) {
    for (std::size_t k = 0; k < multiscans[i].patches.size(); ++k) {
      cells.add(placed(multiscans[i], {i, k}));
    }
  }
  const PartnerSearch search(cells, params);
  std::vector<PatchMatch> matches;
  for (std::size_t i = first; i < multiscans.size(); ++i) {
    for (std::size_t k = 0; k < multiscans[i].patches.size(); ++k) {
      search.append_partners(placed(multiscans[i], {i, k}), matches);
    }
  }
  return matches;
}

}  // namespace echomap::slam
