// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/mapping/polygon_map.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/ros_messages/geometry_msgs.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/visualization_msgs.hpp"

namespace echomap::recording {

/// The map as a grid of 0 (free), 100 (occupied) and -1 (unknown).
ros_messages::OccupancyGrid map_message(std::uint64_t time_ns, const mapping::RasterMap& map);

/// The trajectory, thinned out to poses 5 cm or a sixth of a radian apart.
ros_messages::Path path_message(std::uint64_t time_ns,
                                const std::vector<pipeline::StampedPose>& trajectory);

/// The latest pose with the standard deviation of its position where SLAM has one; covariances that
/// are not known are 0.
ros_messages::PoseWithCovarianceStamped pose_message(std::uint64_t time_ns,
                                                     const pipeline::Snapshot& snapshot);

/// The readings of a stop as one round scan from where the robot is now, one range a degree; where
/// several fall into one the shortest. Empty where nothing was heard.
std::optional<ros_messages::LaserScan> scan_message(std::uint64_t time_ns,
                                                    const mapping::Scan& scan,
                                                    const geometry::Pose2& T_map_robot,
                                                    double max_range_m);

/// Fitted walls, obstacles and the room's outline.
ros_messages::MarkerArray features_message(std::uint64_t time_ns,
                                           const mapping::SonarFeatures& features,
                                           const std::optional<mapping::PolygonMap>& outline);

/// Poses where a robot may be, as of particles.
ros_messages::PoseArray particles_message(std::uint64_t time_ns,
                                          const std::vector<geometry::Pose2>& T_map_robots);

}  // namespace echomap::recording
