// SPDX-License-Identifier: MIT
#include "host/mapping/surface_matching.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

/// Joins pieces that overlap or are nearer to each other than a door.
std::vector<MatchedWall::Piece> joined(std::vector<MatchedWall::Piece> pieces,
                                       double bridged_gap_m) {
  std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return std::pair(a.from_m, a.to_m) < std::pair(b.from_m, b.to_m);
  });
  std::vector<MatchedWall::Piece> joined;
  for (const auto& piece : pieces) {
    if (!joined.empty() && piece.from_m - joined.back().to_m < bridged_gap_m) {
      joined.back().to_m = std::max(joined.back().to_m, piece.to_m);
    } else {
      joined.push_back(piece);
    }
  }
  return joined;
}

/// A smooth wall answers from the foot of the perpendicular: a stop that has heard nothing there,
/// or something farther off, has heard the wall's end, as that of a door's frame.
MatchedWall wall_of(const SupportedFeature& found, const SurfaceMatchingParams& params) {
  MatchedWall wall;
  wall.normal_rad = geometry::wrap_angle(found.feature.value.y());
  wall.offset_m = found.feature.value.x();
  const Eigen::Vector2d along = geometry::perpendicular(geometry::unit_vector(wall.normal_rad));
  for (const Sighting& sighting : found.supporters) {
    const double foot_m = along.dot(sighting.center_m);
    const SonarSurface& surface = sighting.surface;
    wall.pieces.push_back({foot_m - surface.half_length_m, foot_m + surface.half_length_m});
    if (!surface.is_heard_towards(wall.normal_rad)) {
      continue;
    }
    const double distance_m =
        wall.offset_m - geometry::unit_vector(wall.normal_rad).dot(sighting.center_m);
    const double longer_m = surface.range_m - distance_m;
    const bool is_at_foot = longer_m <= params.foot_tolerance_m;
    const double right_m = is_at_foot ? surface.right_m : 0.0;
    const double left_m = is_at_foot ? surface.left_m : 0.0;
    wall.echoes.push_back({foot_m, distance_m, longer_m, right_m, left_m});
    if (is_at_foot) {
      wall.heard.push_back({foot_m - right_m, foot_m + left_m});
    }
  }
  wall.pieces = joined(std::move(wall.pieces), params.bridged_gap_m);
  wall.heard = joined(std::move(wall.heard), params.bridged_gap_m);
  return wall;
}

/// The surface of a scan that fits a feature best, of those that are free.
std::optional<Sighting> best_fit(const FeatureGauge& gauge,
                                 const ScanSurfaces& scan,
                                 std::size_t scan_index,
                                 const std::vector<bool>& is_taken) {
  std::optional<Sighting> best;
  double best_m = 0.0;
  for (std::size_t i = 0; i < scan.surfaces.size(); ++i) {
    const Sighting sighting = sighting_of(scan, scan_index, i);
    const auto misfit_m = is_taken[i] ? std::nullopt : gauge.misfit_m(sighting);
    if (misfit_m && (!best || *misfit_m < best_m)) {
      best = sighting;
      best_m = *misfit_m;
    }
  }
  return best;
}

/// Whether a scan no longer has the surface that a sighting was: it was found anew, or is no more.
/// Where a scan has moved as a whole, ranges stay.
bool is_gone(const Sighting& sighting, const std::vector<ScanSurfaces>& scans, double tolerance_m) {
  if (sighting.scan >= scans.size() || sighting.index >= scans[sighting.scan].surfaces.size()) {
    return true;
  }
  const double range_m = scans[sighting.scan].surfaces[sighting.index].range_m;
  return std::abs(range_m - sighting.surface.range_m) > tolerance_m;
}

}  // namespace

SurfaceMatcher::SurfaceMatcher(const SurfaceMatchingParams& params) : params_(params) {
  validate(params);
}

void SurfaceMatcher::update(const std::vector<ScanSurfaces>& scans,
                            const std::vector<std::size_t>& changed) {
  std::vector<bool> is_moved(scans.size(), false);
  for (const std::size_t scan : changed) {
    is_moved[scan] = true;
  }
  const std::vector<bool> is_rematched = rematched(scans, changed);
  release(scans, is_moved, is_rematched);
  std::vector<bool> is_free = is_rematched;
  for (const std::size_t scan : changed) {
    is_free[scan] = true;
  }
  assign(scans, is_free, 0);
  const std::size_t settled = features_.size();
  FeatureFinder finder(free_sightings(scans, is_rematched),
                       FeatureContradiction(scans, is_rematched, params_),
                       params_);
  while (auto found = finder.take_best()) {
    for (const Sighting& sighting : found->supporters) {
      is_taken_[sighting.scan][sighting.index] = true;
    }
    features_.push_back(std::move(*found));
  }
  std::vector<bool> others = is_rematched;
  others.flip();
  assign(scans, others, settled);
  std::stable_sort(features_.begin(), features_.end(), [](const auto& a, const auto& b) {
    return a.supporters.size() > b.supporters.size();
  });
}

std::vector<bool> SurfaceMatcher::rematched(const std::vector<ScanSurfaces>& scans,
                                            const std::vector<std::size_t>& changed) const {
  std::vector<bool> is_rematched(scans.size(), false);
  if (changed.empty()) {
    return is_rematched;
  }
  const auto rematch_about = [&](const Eigen::Vector2d& about_m) {
    std::vector<std::size_t> nearest(scans.size());
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::stable_sort(nearest.begin(), nearest.end(), [&](std::size_t a, std::size_t b) {
      return (scans[a].center_m - about_m).norm() < (scans[b].center_m - about_m).norm();
    });
    nearest.resize(std::min(nearest.size(), params_.rematched_stops));
    for (const std::size_t scan : nearest) {
      is_rematched[scan] = true;
    }
  };
  const std::size_t known = is_taken_.size();
  for (const std::size_t scan : changed) {
    if (scan >= known || scan == changed.back()) {
      rematch_about(scans[scan].center_m);
    }
  }
  return is_rematched;
}

void SurfaceMatcher::release(const std::vector<ScanSurfaces>& scans,
                             const std::vector<bool>& is_moved,
                             const std::vector<bool>& is_rematched) {
  is_taken_.resize(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    is_taken_[i].assign(scans[i].surfaces.size(), false);
  }
  std::vector<SupportedFeature> kept;
  for (SupportedFeature& known : features_) {
    auto& supporters = known.supporters;
    const bool is_settled = supporters.size() >= params_.settled_sightings;
    bool has_moved = std::erase_if(supporters, [&](const Sighting& one) {
                       return is_gone(one, scans, params_.range_tolerance_m);
                     }) > 0;
    bool is_about = true;
    for (Sighting& sighting : supporters) {
      is_about = is_about && is_rematched[sighting.scan];
      if (is_moved[sighting.scan]) {
        has_moved = true;
        sighting = sighting_of(scans[sighting.scan], sighting.scan, sighting.index);
      }
    }
    if (is_about && !is_settled) {
      continue;
    }
    if (has_moved) {
      known.feature = fitted(known.feature, supporters, params_);
      const FeatureGauge gauge(known.feature, params_);
      std::erase_if(supporters, [&](const Sighting& one) { return !gauge.misfit_m(one); });
    }
    if (supporters.size() < 2) {
      continue;
    }
    for (const Sighting& sighting : supporters) {
      is_taken_[sighting.scan][sighting.index] = true;
    }
    kept.push_back(std::move(known));
  }
  features_ = std::move(kept);
}

void SurfaceMatcher::assign(const std::vector<ScanSurfaces>& scans,
                            const std::vector<bool>& among,
                            std::size_t first_feature) {
  for (std::size_t i = first_feature; i < features_.size(); ++i) {
    SupportedFeature& known = features_[i];
    std::vector<bool> supports(scans.size(), false);
    for (const Sighting& sighting : known.supporters) {
      supports[sighting.scan] = true;
    }
    const FeatureGauge gauge(known.feature, params_);
    bool has_grown = false;
    for (std::size_t scan = 0; scan < scans.size(); ++scan) {
      if (!among[scan] || supports[scan]) {
        continue;
      }
      if (const auto sighting = best_fit(gauge, scans[scan], scan, is_taken_[scan])) {
        is_taken_[scan][sighting->index] = true;
        known.supporters.push_back(*sighting);
        has_grown = true;
      }
    }
    if (has_grown) {
      known.feature = fitted(known.feature, known.supporters, params_);
    }
  }
}

std::vector<Sighting> SurfaceMatcher::free_sightings(const std::vector<ScanSurfaces>& scans,
                                                     const std::vector<bool>& among) const {
  std::vector<Sighting> sightings;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (std::size_t i = 0; among[scan] && i < scans[scan].surfaces.size(); ++i) {
      if (!is_taken_[scan][i]) {
        sightings.push_back(sighting_of(scans[scan], scan, i));
      }
    }
  }
  return sightings;
}

MatchedSurfaces SurfaceMatcher::matched() const {
  MatchedSurfaces matched;
  for (const SupportedFeature& found : features_) {
    if (found.feature.kind == LandmarkKind::kWall) {
      matched.walls.push_back(wall_of(found, params_));
    }
    matched.features.push_back({found.feature, {}});
    for (const Sighting& sighting : found.supporters) {
      matched.features.back().supporters.emplace_back(sighting.scan, sighting.index);
    }
  }
  return matched;
}

MatchedSurfaces match_surfaces(const std::vector<ScanSurfaces>& scans,
                               const SurfaceMatchingParams& params) {
  SurfaceMatchingParams at_once = params;
  at_once.rematched_stops = scans.size();
  std::vector<std::size_t> all(scans.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  SurfaceMatcher matcher(at_once);
  matcher.update(scans, all);
  return matcher.matched();
}

}  // namespace echomap::mapping
