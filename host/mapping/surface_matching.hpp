// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "host/mapping/echo_feature.hpp"
#include "host/mapping/feature_finder.hpp"
#include "host/mapping/feature_support.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// What a stop has heard of a wall from about its foot of the perpendicular.
struct FootEcho {
  double foot_m = 0.0;      ///< Along the wall.
  double distance_m = 0.0;  ///< From the stop to the foot.
  double longer_m = 0.0;    ///< By so much the range was more than that.
  /// How far wall was heard for sure beside the foot (SonarSurface).
  double right_m = 0.0;
  double left_m = 0.0;
};

/// A straight wall that several stops agree on: the points p with n . p = offset, n the unit vector
/// at `normal_rad`, and with n_left . p in one of the pieces.
struct MatchedWall {
  double normal_rad = 0.0;
  double offset_m = 0.0;
  struct Piece {
    double from_m = 0.0;
    double to_m = 0.0;
  };
  /// In order, apart from each other.
  std::vector<Piece> pieces;
  /// The same of those from which a stop has had an answer at right angles. Between them may be
  /// doors.
  std::vector<Piece> heard = {};
  std::vector<FootEcho> echoes = {};
};

/// A feature and the sightings that it was made of.
struct MatchedFeature {
  EchoFeature feature;
  /// Scan and index of the surface in it; at most one of each scan.
  std::vector<std::pair<std::size_t, std::size_t>> supporters;
};

/// What all stops together have seen, in the map frame.
struct MatchedSurfaces {
  std::vector<MatchedWall> walls;
  /// Walls, posts and round things; the walls in the order of `walls`.
  std::vector<MatchedFeature> features;
};

/// Finds what several stops have seen as the stops come: a new one is matched with what is settled,
/// and, with the stops about it, for what is not. Ranges from two places fix a surface much better
/// than the bearing from one.
class SurfaceMatcher {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SurfaceMatcher(const SurfaceMatchingParams& params = {});

  /// Takes all scans as they are placed now. `changed` are the indices of those that are new or
  /// were moved since the last time.
  void update(const std::vector<ScanSurfaces>& scans, const std::vector<std::size_t>& changed);

  MatchedSurfaces matched() const;

 private:
  std::vector<bool> rematched(const std::vector<ScanSurfaces>& scans,
                              const std::vector<std::size_t>& changed) const;
  /// Places the sightings of features anew, and lets go those that no longer fit and the features
  /// that are not settled.
  void release(const std::vector<ScanSurfaces>& scans,
               const std::vector<bool>& is_moved,
               const std::vector<bool>& is_rematched);
  /// Hands the surfaces of the scans that no feature has to `features_`, each to the first that it
  /// fits.
  void assign(const std::vector<ScanSurfaces>& scans,
              const std::vector<bool>& among,
              std::size_t first_feature);
  std::vector<Sighting> free_sightings(const std::vector<ScanSurfaces>& scans,
                                       const std::vector<bool>& among) const;

  SurfaceMatchingParams params_;
  std::vector<SupportedFeature> features_;   ///< The best supported first.
  std::vector<std::vector<bool>> is_taken_;  ///< By scan and surface.
};

/// What the scans together have seen, all of them matched at once.
MatchedSurfaces match_surfaces(const std::vector<ScanSurfaces>& scans,
                               const SurfaceMatchingParams& params);

}  // namespace echomap::mapping
