// SPDX-License-Identifier: MIT
#include "host/mapping/surface_matching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/echo_feature.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/normal_equations.hpp"

namespace echomap::mapping {

namespace {

constexpr int kFitSteps = 3;

/// A surface with the place it was seen from.
struct Sighting {
  std::size_t scan = 0;
  std::size_t index = 0;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  SonarSurface surface;

  RangeCircle circle() const { return {center_m, surface.range_m}; }
};

bool is_wall(const EchoFeature& feature) { return feature.kind == LandmarkKind::kWall; }

/// A feature and what supports it.
struct Proposal {
  EchoFeature feature;
  /// Indices of the sightings, at most one for each scan.
  std::vector<std::size_t> supporters;
  double support = 0.0;
};

std::vector<Sighting> sightings_of(const std::vector<ScanSurfaces>& scans) {
  std::vector<Sighting> sightings;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (std::size_t index = 0; index < scans[scan].surfaces.size(); ++index) {
      sightings.push_back({scan, index, scans[scan].center_m, scans[scan].surfaces[index]});
    }
  }
  return sightings;
}

class FeatureFinder {
 public:
  FeatureFinder(std::vector<Sighting> sightings, const SurfaceMatchingParams& params)
      : sightings_(std::move(sightings)), taken_(sightings_.size(), false), params_(params) {
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
      for (std::size_t j = i + 1; j < sightings_.size(); ++j) {
        propose(i, j);
      }
    }
  }

  const Sighting& sighting(std::size_t index) const { return sightings_[index]; }

  /// The proposal with the most support, fitted; its supporters support nothing else from then on.
  /// Support only shrinks as others take sightings, so a proposal that is still ahead of the stale
  /// support of the next is the best.
  std::optional<Proposal> take_best() {
    while (!queue_.empty() && queue_.top().first >= params_.min_support) {
      const std::size_t index = queue_.top().second;
      queue_.pop();
      gather(proposals_[index]);
      const double support = proposals_[index].support;
      if (proposals_[index].supporters.size() < 2 || support < params_.min_support) {
        continue;
      }
      if (!queue_.empty() && support < queue_.top().first) {
        queue_.emplace(support, index);
        continue;
      }
      return take(proposals_[index]);
    }
    return std::nullopt;
  }

 private:
  void propose(std::size_t first, std::size_t second) {
    if (sightings_[first].scan == sightings_[second].scan) {
      return;
    }
    for (const auto& feature :
         features_through(sightings_[first].circle(), sightings_[second].circle())) {
      if (misfit_m(feature, sightings_[first]) && misfit_m(feature, sightings_[second])) {
        Proposal proposal{feature, {}, 0.0};
        gather(proposal);
        queue_.emplace(proposal.support, proposals_.size());
        proposals_.push_back(std::move(proposal));
      }
    }
  }

  /// How far a sighting's range is off; empty where it cannot be of that feature.
  std::optional<double> misfit_m(const EchoFeature& feature, const Sighting& sighting) const {
    const FeatureView view = view_from(sighting.center_m, feature);
    const double off_rad =
        std::abs(geometry::angle_between(view.bearing_rad, sighting.surface.bearing_rad));
    const double misfit_m = std::abs(view.range_m - sighting.surface.range_m);
    const double bearing_tolerance_rad =
        is_wall(feature) ? params_.wall_bearing_tolerance_rad : params_.post_bearing_tolerance_rad;
    if (off_rad > bearing_tolerance_rad || misfit_m > params_.range_tolerance_m) {
      return std::nullopt;
    }
    return misfit_m;
  }

  double weight(const EchoFeature& feature, const Sighting& sighting, double misfit_m) const {
    const double readings = static_cast<double>(sighting.surface.readings);
    const double relative = misfit_m / params_.range_tolerance_m;
    const bool looks_like_wall = sighting.surface.half_length_m > 0.0;
    return std::min(1.0, readings / params_.full_readings) * (1.0 - 0.5 * relative * relative) *
           (looks_like_wall == is_wall(feature) ? 1.0 : params_.other_kind_weight);
  }

  /// Collects, of each scan, the sighting that fits best.
  void gather(Proposal& proposal) const {
    proposal.supporters.clear();
    proposal.support = 0.0;
    std::size_t scan = std::numeric_limits<std::size_t>::max();
    double best_m = 0.0;
    double best_weight = 0.0;
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
      const auto misfit = taken_[i] ? std::nullopt : misfit_m(proposal.feature, sightings_[i]);
      if (!misfit) {
        continue;
      }
      if (sightings_[i].scan != scan) {
        scan = sightings_[i].scan;
        proposal.supporters.push_back(i);
      } else if (*misfit < best_m) {
        proposal.supporters.back() = i;
        proposal.support -= best_weight;
      } else {
        continue;
      }
      best_m = *misfit;
      best_weight = weight(proposal.feature, sightings_[i], *misfit);
      proposal.support += best_weight;
    }
  }

  /// Least squares over ranges and bearings of the supporters (Gauss and Newton).
  void fit(Proposal& proposal) const {
    const Eigen::Vector2d variance(geometry::square(params_.range_stddev_m),
                                   geometry::square(params_.bearing_stddev_rad));
    const Eigen::Matrix2d information = variance.cwiseInverse().asDiagonal();
    const auto linearize = [&] {
      optimization::NormalEquations<2> equations;
      for (const std::size_t index : proposal.supporters) {
        const auto& surface = sightings_[index].surface;
        const FeatureView view = view_from(sightings_[index].center_m, proposal.feature);
        const Eigen::Vector2d residual(
            view.range_m - surface.range_m,
            geometry::angle_between(surface.bearing_rad, view.bearing_rad));
        equations.add<2>(residual, view.jacobian, information);
      }
      return equations;
    };
    optimization::gauss_newton(kFitSteps, linearize, [&](const Eigen::Vector2d& step) {
      proposal.feature.value += step;
      return false;
    });
  }

  std::optional<Proposal> take(Proposal proposal) {
    fit(proposal);
    const Proposal before = proposal;
    gather(proposal);
    if (proposal.supporters.size() < 2) {
      proposal = before;
    }
    for (const std::size_t index : proposal.supporters) {
      taken_[index] = true;
    }
    return proposal;
  }

  std::vector<Sighting> sightings_;
  std::vector<bool> taken_;
  const SurfaceMatchingParams& params_;
  std::vector<Proposal> proposals_;
  std::priority_queue<std::pair<double, std::size_t>> queue_;
};

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

MatchedWall wall_of(const Proposal& proposal, const FeatureFinder& finder, double bridged_gap_m) {
  MatchedWall wall;
  wall.normal_rad = geometry::wrap_angle(proposal.feature.value.y());
  wall.offset_m = proposal.feature.value.x();
  const Eigen::Vector2d along = geometry::perpendicular(geometry::unit_vector(wall.normal_rad));
  for (const std::size_t index : proposal.supporters) {
    const Sighting& sighting = finder.sighting(index);
    const double foot_m = along.dot(sighting.center_m);
    wall.pieces.push_back(
        {foot_m - sighting.surface.half_length_m, foot_m + sighting.surface.half_length_m});
  }
  wall.pieces = joined(std::move(wall.pieces), bridged_gap_m);
  return wall;
}

/// Adds a feature, and makes the surfaces that support it agree with it.
void add(const Proposal& proposal,
         const FeatureFinder& finder,
         double bridged_gap_m,
         MatchedSurfaces& matched) {
  if (is_wall(proposal.feature)) {
    matched.walls.push_back(wall_of(proposal, finder, bridged_gap_m));
  } else {
    matched.posts_m.push_back(proposal.feature.value);
  }
  matched.features.push_back({proposal.feature, {}});
  for (const std::size_t index : proposal.supporters) {
    const Sighting& sighting = finder.sighting(index);
    matched.features.back().supporters.emplace_back(sighting.scan, sighting.index);
    SonarSurface& surface = matched.scans[sighting.scan].surfaces[sighting.index];
    const FeatureView view = view_from(sighting.center_m, proposal.feature);
    surface.bearing_rad = geometry::wrap_angle(view.bearing_rad);
    surface.range_m = view.range_m;
    surface.half_length_m = is_wall(proposal.feature) ? surface.half_length_m : 0.0;
  }
}

}  // namespace

MatchedSurfaces match_surfaces(std::vector<ScanSurfaces> scans,
                               const SurfaceMatchingParams& params) {
  FeatureFinder finder(sightings_of(scans), params);
  MatchedSurfaces matched{std::move(scans), {}, {}, {}};
  while (true) {
    const auto proposal = finder.take_best();
    if (!proposal) {
      return matched;
    }
    add(*proposal, finder, params.bridged_gap_m, matched);
  }
}

}  // namespace echomap::mapping
