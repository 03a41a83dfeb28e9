// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/cell_sums.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// Where a surface that one stop alone has seen takes back as much evidence for floor as a stop
/// gives: something is there, and nobody knows yet what.
struct LoneSurfaceParams {
  /// Depth of the region behind its face, metres.
  double depth_m = 0.15;
  /// Half width of that region as an angle at the stop, radians.
  double half_angle_rad = 0.07;
};

/// A surface that no feature explains.
struct LoneSurface {
  /// The stop that has seen it.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  SonarSurface surface;
  /// Evidence for floor that it takes back, in hundredths of log-odds.
  int doubt_centilogits = 0;

  bool operator==(const LoneSurface&) const = default;
};

/// Doubt about the floor behind lone surfaces, summed over them. Only stops whose lone
/// surfaces have come, gone or moved change cells.
class LoneSurfaces {
 public:
  LoneSurfaces(const LoneSurfaceParams& params, double resolution_m)
      : params_(params), resolution_m_(resolution_m) {}

  /// The lone surfaces of stop `index`, in place of those of before. Stops are numbered from 0.
  void set(std::size_t index, std::vector<LoneSurface> surfaces);
  /// Forgets the stops from that number on.
  void resize(std::size_t stops);

  /// Summed doubt, in hundredths of log-odds.
  int centilogits(geometry::CellIndex cell) const { return sums_.at(cell); }

 private:
  void add(const LoneSurface& lone, int doubt_centilogits);
  /// The cells right behind its face.
  std::vector<geometry::CellIndex> cells_behind(const LoneSurface& lone) const;

  LoneSurfaceParams params_;
  double resolution_m_;
  std::vector<std::vector<LoneSurface>> stops_;
  CellSums sums_;
};

}  // namespace echomap::mapping
