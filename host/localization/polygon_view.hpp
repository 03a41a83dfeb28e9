// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/geometry/reflex_outline.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/models/contact_likelihood.hpp"
#include "host/models/range_likelihood.hpp"

namespace echomap::localization {

/// The range sensor of a PolygonView; the defaults are those of an e-puck's infra-red sensor.
struct PolygonViewParams {
  double max_range_m = 0.06;
  /// A wall whose normal is farther off the beam is seen aslant.
  double oblique_above_rad = 0.4363;  ///< 25 degrees.
};

/// What sensors are to expect in a room of straight walls (Mukherjee et al.).
class PolygonView {
 public:
  /// Throws std::invalid_argument for a parameter that is not above 0.
  explicit PolygonView(const mapping::PolygonMap& map, const PolygonViewParams& params = {});

  /// Of a thin beam.
  models::ExpectedRange expected(const geometry::Pose2& T_map_sensor) const;
  /// Of a round body with a bumper in front.
  models::WallAhead wall_ahead(const geometry::Pose2& T_map_robot, double radius_m) const;
  /// Inside of the outline and of no hole, as the paper tells it (geometry::ReflexOutline).
  bool is_floor(const Eigen::Vector2d& point_m) const;

 private:
  PolygonViewParams params_;
  std::vector<geometry::Segment> walls_;
  geometry::ReflexOutline outline_;
  std::vector<geometry::ReflexOutline> holes_;
};

/// The floor of a polygon map in cells; those whose middle is not on it are occupied. Throws
/// std::invalid_argument for a resolution that is not above 0.
mapping::RasterMap rasterize(const mapping::PolygonMap& map, double resolution_m);

}  // namespace echomap::localization
