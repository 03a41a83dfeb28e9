// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/models/range_likelihood.hpp"

namespace echomap::localization {

/// How a range is looked up in a cloud of points; ours.
struct PointCloudViewParams {
  /// A point is on a beam that passes it so near, or off by so small an angle. Singh and Bedi take
  /// bearings that agree to 0.01 rad, by which most beams pass between all points of their map,
  /// which stand 6 degrees apart.
  double half_width_m = 0.03;
  double beam_half_angle_rad = 0.0523599;  ///< 3 degrees.
  double max_range_m = 2.55;
};

/// What a range sensor is to expect in the map of Singh and Bedi 2013, a cloud of echo points: the
/// nearest point on its beam (Algorithm 1, lines 12 to 28, which multiplies over all of them, also
/// those behind a wall).
class PointCloudView {
 public:
  /// Throws std::invalid_argument for a parameter that is not above 0.
  explicit PointCloudView(const std::vector<Eigen::Vector2d>& points_m,
                          const PointCloudViewParams& params = {});

  models::ExpectedRange expected(const geometry::Pose2& T_map_sensor) const;
  /// The map says nothing of where a robot cannot be.
  bool is_floor(const Eigen::Vector2d& /*point_m*/) const { return true; }

 private:
  PointCloudViewParams params_;
  double slope_;  ///< Of a beam's edge.
  /// With far points to fill up the last lanes.
  std::vector<float> x_m_;
  std::vector<float> y_m_;
};

/// The middles of a map's occupied cells.
std::vector<Eigen::Vector2d> occupied_points(const mapping::RasterMap& map);

}  // namespace echomap::localization
