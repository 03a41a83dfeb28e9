// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/pose_hypotheses.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// How differently a map looks from several places: where a robot that may be at any of them has to
/// go so that what it hears there tells them apart (active localization, Fox, Burgard and Thrun
/// 1998, with a difference of views in place of the entropy of a belief). Where the map does not
/// know what a ray meets, a range tells places apart only as far as one of them has floor there; a
/// goal outside of the map tells nothing, one in a wall much.
class ViewDifference {
 public:
  /// Of a sensor that sees so far, metres.
  ViewDifference(const mapping::RasterMap& map, double max_range_m);

  /// Within [0, 1]: the mean difference of a range all round, of which half a metre counts at most,
  /// over pairs of hypotheses, by the product of their probabilities, once the robot has gone on to
  /// `T_robot_goal`. 0 for one hypothesis alone.
  double telling(const std::vector<PoseHypothesis>& hypotheses,
                 const geometry::Pose2& T_robot_goal) const;

 private:
  /// Along rays all round: how far floor is known, and where a surface is, which may be behind.
  struct View {
    std::vector<float> floor_m;
    std::vector<float> surface_m;
  };

  View view_from(const geometry::Pose2& T_map_robot) const;
  static double difference(const View& one, const View& other);

  mapping::RasterMap map_;
  mapping::DistanceField surfaces_;
  mapping::DistanceField known_floor_;
  double max_range_m_;
};

}  // namespace echomap::localization
