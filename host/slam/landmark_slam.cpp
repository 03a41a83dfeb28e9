// SPDX-License-Identifier: MIT
#include "host/slam/landmark_slam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/slam/joint_compatibility.hpp"

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
         0.5 * (landmark.along_from_m + landmark.along_to_m) * quarter_turned(normal);
}

/// Whether the beam that points to a place of the map ends well behind it.
bool passes(const RangeScan& scan,
            const Pose2& T_map_sensor,
            const Eigen::Vector2d& place_m,
            double margin_m) {
  const Eigen::Vector2d seen_m = T_map_sensor.inverse() * place_m;
  const double bearing_rad = std::atan2(seen_m.y(), seen_m.x());
  const auto nearest = std::min_element(
      scan.beams.begin(), scan.beams.end(), [&](const RangeBeam& left, const RangeBeam& right) {
        return std::abs(geometry::angle_between(bearing_rad, left.bearing_rad)) <
               std::abs(geometry::angle_between(bearing_rad, right.bearing_rad));
      });
  if (nearest == scan.beams.end() || !nearest->range_m) {
    return false;
  }
  constexpr double kWidestBeamRad = 0.02;
  const double off_rad = std::abs(geometry::angle_between(bearing_rad, nearest->bearing_rad));
  const double beyond_m = *nearest->range_m - seen_m.norm();
  return off_rad < kWidestBeamRad && beyond_m > margin_m;
}

/// Nothing where all of it is known: then it is where the map begins.
void add_pose(const localization::PoseGaussian& pose, FactorGraph& graph) {
  if (!localization::is_covariance(pose.covariance)) {
    return;
  }
  const Eigen::Matrix3d information = pose.covariance.llt().solve(Eigen::Matrix3d::Identity());
  graph.edges.push_back({0,
                         graph.T_map_nodes.size(),
                         graph.T_map_nodes.front().inverse() * pose.T_map_robot,
                         in_frame_of(pose.T_map_robot, information),
                         false});
  graph.T_map_nodes.push_back(pose.T_map_robot);
}

void add_landmark(const Eigen::Vector2d& place_m,
                  const Eigen::Matrix2d& covariance,
                  FactorGraph& graph) {
  const Pose2 T_first_map = graph.T_map_nodes.front().inverse();
  const Eigen::Matrix2d to_first = Eigen::Rotation2Dd(T_first_map.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d on_axes_of_first = to_first * covariance * to_first.transpose();
  graph.landmark_edges.push_back({0,
                                  graph.landmarks_m.size(),
                                  T_first_map * place_m,
                                  on_axes_of_first.llt().solve(Eigen::Matrix2d::Identity())});
  graph.landmarks_m.push_back(place_m);
}

}  // namespace

LandmarkSlam::LandmarkSlam(const LandmarkSlamParams& params)
    : params_(params),
      motion_(params.motion),
      filter_(params.filter),
      provisional_(params.provisional) {
  const bool sense = params.association.gate > 0.0 &&
                     params.association.gate_of_new >= params.association.gate &&
                     params.pruned_share > 0.0 && params.most_kept >= 2;
  if (!sense) {
    throw std::invalid_argument(
        "landmark slam: gates and shares are above 0, at least two poses kept");
  }
}

void LandmarkSlam::add(const Pose2& T_odom_robot, const RangeScan& scan) {
  move_to(T_odom_robot);
  const auto sightings = extract_landmarks(scan, params_.extraction);
  const auto near = find_candidates(
      filter_, sightings, params_.association.gate_of_new, params_.association.widest_wall_gap_m);
  correct(sightings, paired(near));
  extend(sightings, new_sightings(sightings.size(), near), T_odom_robot);
  prune(scan);
  keep_pose();
  scans_.push_back(scan);
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
    filter_ = EkfSlam({&start, 1}, params_.filter);
  }
  T_odom_robot_ = T_odom_robot;
}

std::vector<Candidate> LandmarkSlam::paired(std::span<const Candidate> candidates) const {
  std::vector<Candidate> within;
  std::copy_if(candidates.begin(),
               candidates.end(),
               std::back_inserter(within),
               [&](const Candidate& candidate) {
                 return candidate.squared_distance <= params_.association.gate;
               });
  return params_.method == AssociationMethod::kJointCompatibility
             ? jointly_compatible(filter_, within, params_.association.most_steps)
             : nearest_neighbours(std::move(within));
}

void LandmarkSlam::correct(std::span<const LandmarkSighting> sightings,
                           std::span<const Candidate> pairs) {
  std::vector<LinearSighting> linear;
  for (const Candidate& pair : pairs) {
    linear.push_back(pair.linear);
  }
  filter_.update(linear);
  for (const Candidate& pair : pairs) {
    filter_.note(sightings[pair.sighting], pair.landmark);
  }
}

void LandmarkSlam::extend(std::span<const LandmarkSighting> sightings,
                          std::span<const std::size_t> unknown,
                          const Pose2& T_odom_robot) {
  std::vector<LandmarkSighting> unpaired;
  for (const std::size_t i : unknown) {
    unpaired.push_back(sightings[i]);
  }
  for (const LandmarkSighting& sighting : provisional_.confirmed(unpaired, T_odom_robot)) {
    filter_.add(sighting);
  }
}

/// What beams pass through is not there, or no longer.
void LandmarkSlam::prune(const RangeScan& scan) {
  const Pose2 T_map_sensor = filter_.belief().T_map_robot * scan.T_robot_sensor;
  for (std::size_t i = filter_.landmarks().size(); i-- > 0;) {
    if (passes(scan, T_map_sensor, middle_m(filter_.landmarks()[i]), params_.pass_margin_m)) {
      filter_.note_pass(i);
    }
    const Landmark& landmark = filter_.landmarks()[i];
    if (landmark.passes >= params_.least_passes &&
        static_cast<double>(landmark.passes) >
            params_.pruned_share * static_cast<double>(landmark.sightings)) {
      filter_.remove(i);
    }
  }
}

void LandmarkSlam::keep_pose() {
  const Pose2 T_map_robot = filter_.belief().T_map_robot;
  const auto T_kept_robot = [&] {
    return filter_.T_map_kept(filter_.kept_poses() - 1).inverse() * T_map_robot;
  };
  const bool is_due =
      filter_.kept_poses() == 0 ||
      T_kept_robot().position_m().norm() >= kept_every_ * params_.kept_every_m ||
      std::abs(T_kept_robot().heading_rad()) >= kept_every_ * params_.kept_every_rad;
  if (is_due) {
    filter_.keep_pose();
  }
  instants_.push_back({filter_.kept_poses() - 1, T_kept_robot()});
  if (filter_.kept_poses() > params_.most_kept) {
    thin_out_kept();
  }
}

/// Every other kept pose goes; what hung on it now hangs on the one before.
void LandmarkSlam::thin_out_kept() {
  kept_every_ *= 2.0;
  for (Instant& instant : instants_) {
    if (instant.kept % 2 == 1) {
      const Pose2 T_before_kept =
          filter_.T_map_kept(instant.kept - 1).inverse() * filter_.T_map_kept(instant.kept);
      instant.T_kept_robot = T_before_kept * instant.T_kept_robot;
    }
    instant.kept /= 2;
  }
  const std::size_t kept = filter_.kept_poses();
  for (std::size_t i = kept; i-- > 0;) {
    if (i % 2 == 1) {
      filter_.forget_pose(i);
    }
  }
}

std::vector<geometry::Pose2> LandmarkSlam::trajectory() const {
  std::vector<Pose2> T_map_robots;
  T_map_robots.reserve(instants_.size());
  for (const Instant& instant : instants_) {
    T_map_robots.push_back(filter_.T_map_kept(instant.kept) * instant.T_kept_robot);
  }
  return T_map_robots;
}

mapping::OccupancyGrid LandmarkSlam::grid() const {
  const std::vector<Pose2> T_map_robots = trajectory();
  std::vector<PlacedScan> placed;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    placed.push_back({T_map_robots[i], scans_[i]});
  }
  return map_of_scans(placed, params_.map);
}

FactorGraph LandmarkSlam::factor_graph() const {
  FactorGraph graph;
  if (filter_.kept_poses() == 0) {
    return graph;
  }
  graph.T_map_nodes = {filter_.T_map_kept(0)};
  for (std::size_t kept = 1; kept < filter_.kept_poses(); ++kept) {
    add_pose({filter_.T_map_kept(kept), filter_.kept_covariance(kept)}, graph);
  }
  add_pose(filter_.belief(), graph);
  for (std::size_t i = 0; i < filter_.landmarks().size(); ++i) {
    if (const Landmark& landmark = filter_.landmarks()[i]; landmark.kind == LandmarkKind::kPoint) {
      add_landmark(landmark.value, filter_.landmark_covariance(i), graph);
    }
  }
  return graph;
}

}  // namespace echomap::slam
