// SPDX-License-Identifier: MIT
#include "host/slam/patch_matching.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/point_buckets.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

/// Standard deviations.
constexpr double kGate = 3.0;

struct PlacedPatch {
  PatchIndex index;
  Eigen::Vector2d point_m;
  double normal_rad = 0.0;
  const PlacedPatches* multiscan = nullptr;
};

/// Variance of where the patch lies along `direction`, by what is not known of its multiscan.
double place_variance_m2(const PlacedPatch& patch, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d lever_m = patch.point_m - patch.multiscan->T_map_begin.position_m();
  const Eigen::Vector3d by_place(
      direction.x(), direction.y(), direction.y() * lever_m.x() - direction.x() * lever_m.y());
  return by_place.dot(patch.multiscan->covariance * by_place);
}

PlacedPatch placed(const PlacedPatches& multiscan, PatchIndex index) {
  const SurfacePatch& patch = multiscan.patches[index.patch];
  return {index,
          multiscan.T_map_begin * patch.point_m,
          geometry::wrap_angle(multiscan.T_map_begin.heading_rad() + patch.normal_rad),
          &multiscan};
}

/// Patches by the square of the map that they lie in.
using PatchCells = geometry::PointBuckets<PlacedPatch>;

struct Candidate {
  PatchMatch match;
  double squares_m2 = 0.0;
};
/// The nearest patch of each multiscan, in the order of time.
using Candidates = std::map<std::size_t, Candidate>;

class PartnerSearch {
 public:
  PartnerSearch(const PatchCells& cells, const PatchMatchingParams& params)
      : cells_(cells), params_(params) {}

  void append_partners(const PlacedPatch& patch, std::vector<PatchMatch>& matches) const {
    std::vector<PatchMatch> visit;
    std::vector<PatchMatch> revisits;
    for (const auto& [multiscan, candidate] : candidates_of(patch)) {
      (candidate.match.is_revisit ? revisits : visit).push_back(candidate.match);
    }
    const std::size_t latest = std::min(visit.size(), params_.max_partners);
    matches.insert(matches.end(), visit.end() - static_cast<std::ptrdiff_t>(latest), visit.end());
    const std::size_t spread = std::min(revisits.size(), params_.max_partners);
    for (std::size_t i = 0; i < spread; ++i) {
      matches.push_back(revisits[i * revisits.size() / spread]);
    }
  }

 private:
  Candidates candidates_of(const PlacedPatch& patch) const {
    Candidates candidates;
    cells_.visit_near(patch.point_m, [&](const PlacedPatch& other) {
      if (other.index.multiscan >= patch.index.multiscan) {
        return;
      }
      const auto match = match_of(patch, other);
      if (!match) {
        return;
      }
      const Candidate candidate{*match, (patch.point_m - other.point_m).squaredNorm()};
      const auto [found, is_new] = candidates.try_emplace(other.index.multiscan, candidate);
      if (!is_new && candidate.squares_m2 < found->second.squares_m2) {
        found->second = candidate;
      }
    });
    return candidates;
  }

  std::optional<PatchMatch> match_of(const PlacedPatch& patch, const PlacedPatch& other) const {
    const Eigen::Vector2d normal = geometry::unit_vector(other.normal_rad);
    const Eigen::Vector2d apart_m = patch.point_m - other.point_m;
    const double along_m = std::abs(normal.x() * apart_m.y() - normal.y() * apart_m.x());
    if (along_m > params_.along_m ||
        std::abs(geometry::angle_between(other.normal_rad, patch.normal_rad)) >
            params_.max_angle_rad) {
      return std::nullopt;
    }
    const bool is_revisit =
        patch.index.multiscan - other.index.multiscan > params_.visit_multiscans;
    const double place_stddev_m = is_revisit ? place_stddev(patch, other, normal) : 0.0;
    if (std::abs(normal.dot(apart_m)) >
        kGate * std::hypot(params_.across_stddev_m, place_stddev_m)) {
      return std::nullopt;
    }
    return PatchMatch{patch.index, other.index, is_revisit, place_stddev_m};
  }

  double place_stddev(const PlacedPatch& patch,
                      const PlacedPatch& other,
                      const Eigen::Vector2d& normal) const {
    const double variance_m2 = place_variance_m2(patch, normal) + place_variance_m2(other, normal);
    return std::min(std::sqrt(variance_m2), params_.max_place_stddev_m);
  }

  const PatchCells& cells_;
  const PatchMatchingParams& params_;
};

double reach_m(const PatchMatchingParams& params) {
  return std::hypot(params.along_m,
                    kGate * std::hypot(params.across_stddev_m, params.max_place_stddev_m));
}

}  // namespace

void validate(const PatchMatchingParams& params) {
  geometry::ParameterValidator("patch matching")
      .positive("along_m", params.along_m)
      .positive("across_stddev_m", params.across_stddev_m)
      .at_least("max_place_stddev_m", params.max_place_stddev_m, 0.0)
      .positive("max_angle_rad", params.max_angle_rad)
      .positive("max_partners", params.max_partners)
      .require(std::isfinite(reach_m(params)), "along_m and the deviations must be finite");
}

std::vector<PatchMatch> match_patches(const std::vector<PlacedPatches>& multiscans,
                                      std::size_t first,
                                      const PatchMatchingParams& params) {
  PatchCells cells(reach_m(params));
  for (std::size_t i = 0; i < multiscans.size(); ++i) {
    for (std::size_t k = 0; k < multiscans[i].patches.size(); ++k) {
      const PlacedPatch patch = placed(multiscans[i], {i, k});
      cells.add(patch.point_m, patch);
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
