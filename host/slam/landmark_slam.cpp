// SPDX-License-Identifier: MIT
#include "host/slam/landmark_slam.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

/// The middle of what has been seen of a landmark.
Eigen::Vector2d middle_m(const Landmark& landmark) {
  if (landmark.kind == LandmarkKind::kPoint) {
    return landmark.value;
  }
  const Eigen::Vector2d normal = geometry::unit_vector(landmark.value.y());
  return landmark.value.x() * normal +
         0.5 * (landmark.along_from_m + landmark.along_to_m) * geometry::perpendicular(normal);
}

/// Whether the beam that points to a place of the map ends well behind it.
bool passes(const sensors::RangeScan& scan,
            const Pose2& T_map_sensor,
            const Eigen::Vector2d& place_m,
            double margin_m) {
  const Eigen::Vector2d seen_m = T_map_sensor.inverse() * place_m;
  const double bearing_rad = std::atan2(seen_m.y(), seen_m.x());
  const auto nearest =
      std::min_element(scan.beams.begin(),
                       scan.beams.end(),
                       [&](const sensors::Beam& left, const sensors::Beam& right) {
                         return std::abs(geometry::angle_between(bearing_rad, left.bearing_rad)) <
                                std::abs(geometry::angle_between(bearing_rad, right.bearing_rad));
                       });
  const auto range_m = nearest == scan.beams.end() ? std::nullopt : nearest->range_m;
  if (!range_m) {
    return false;
  }
  constexpr double kMaxBeamRad = 0.02;
  const double off_rad = std::abs(geometry::angle_between(bearing_rad, nearest->bearing_rad));
  const double beyond_m = *range_m - seen_m.norm();
  return off_rad < kMaxBeamRad && beyond_m > margin_m;
}

}  // namespace

LandmarkSlam::LandmarkSlam(const LandmarkSlamParams& params)
    : params_(params),
      motion_(params.motion),
      filter_(params.filter),
      update_(params.update),
      pose_history_(params.pose_history) {
  geometry::ParameterValidator("landmark slam").positive("pruned_share", params.pruned_share);
}

void LandmarkSlam::add(const Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  move_to(T_odom_robot);
  update_.add_sightings(extract_landmarks(scan, params_.extraction), T_odom_robot, filter_);
  prune(scan);
  pose_history_.keep(filter_);
  pose_history_.add({});
}

/// The map frame is that of the odometry at the first scan.
void LandmarkSlam::move_to(const Pose2& T_odom_robot) {
  if (T_odom_robot_) {
    const models::OdometryStep step = models::odometry_step(*T_odom_robot_, T_odom_robot);
    filter_.move(0,
                 T_odom_robot_->inverse() * T_odom_robot,
                 step,
                 models::cut_step_spread(motion_, step, params_.whole_step));
  } else {
    const localization::PoseGaussian start{T_odom_robot, params_.start_covariance};
    filter_ = EkfSlamFilter({&start, 1}, params_.filter);
  }
  T_odom_robot_ = T_odom_robot;
}

/// What beams pass through is not there, or no longer.
void LandmarkSlam::prune(const sensors::RangeScan& scan) {
  const Pose2 T_map_sensor = filter_.belief().T_map_robot * scan.T_robot_sensor;
  for (std::size_t i = filter_.landmarks().size(); i-- > 0;) {
    if (passes(scan, T_map_sensor, middle_m(filter_.landmarks()[i]), params_.pass_margin_m)) {
      filter_.note_pass(i);
    }
    const Landmark& landmark = filter_.landmarks()[i];
    if (landmark.passes >= params_.min_passes &&
        static_cast<double>(landmark.passes) >
            params_.pruned_share * static_cast<double>(landmark.sightings)) {
      filter_.remove(i);
    }
  }
}

}  // namespace echomap::slam
