// SPDX-License-Identifier: MIT
#include "host/recording/map_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/recording/observation_messages.hpp"

namespace echomap::recording {
namespace {

using namespace ros_messages;

constexpr std::int8_t kFreeCell = 0;
constexpr std::int8_t kOccupiedCell = 100;
constexpr double kPathStepM = 0.05;
constexpr double kPathStepRad = std::numbers::pi / 18.0;
constexpr std::size_t kScanBearings = 360;
constexpr double kWallLineM = 0.03;

bool is_a_step(const geometry::Pose2& T_map_last, const geometry::Pose2& T_map_next) {
  const geometry::Pose2 T_last_next = T_map_last.inverse() * T_map_next;
  return T_last_next.position_m().norm() >= kPathStepM ||
         std::abs(T_last_next.heading_rad()) >= kPathStepRad;
}

Marker line_marker(std::uint64_t time_ns,
                   const std::string& name,
                   std::int32_t type,
                   const ColorRGBA& colour) {
  Marker marker;
  marker.header = header_of(time_ns, kMapFrame);
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = kWallLineM;
  marker.color = colour;
  return marker;
}

Marker ring_marker(std::uint64_t time_ns,
                   const std::string& name,
                   std::int32_t id,
                   const geometry::Polygon& ring_m,
                   const ColorRGBA& colour) {
  Marker marker = line_marker(time_ns, name, Marker::kLineStrip, colour);
  marker.id = id;
  marker.points.reserve(ring_m.size() + 1);
  for (const Eigen::Vector2d& corner_m : ring_m) {
    marker.points.push_back(point_of(corner_m));
  }
  if (!ring_m.empty()) {
    marker.points.push_back(point_of(ring_m.front()));
  }
  return marker;
}

}  // namespace

OccupancyGrid map_message(std::uint64_t time_ns, const mapping::RasterMap& map) {
  OccupancyGrid message;
  message.header = header_of(time_ns, kMapFrame);
  message.info.map_load_time = stamp_of(time_ns);
  message.info.resolution = static_cast<float>(map.resolution_m());
  message.info.width = static_cast<std::uint32_t>(map.columns());
  message.info.height = static_cast<std::uint32_t>(map.rows());
  message.info.origin = pose_of({map.origin_m().x(), map.origin_m().y(), 0.0});
  message.data.reserve(static_cast<std::size_t>(map.columns()) *
                       static_cast<std::size_t>(map.rows()));
  for (int y = 0; y < map.rows(); ++y) {
    const mapping::CellState* const row = map.row(y);
    std::transform(
        row, row + map.columns(), std::back_inserter(message.data), [](mapping::CellState state) {
          return state == mapping::CellState::kUnknown ? OccupancyGrid::kUnknown
                 : state == mapping::CellState::kFree  ? kFreeCell
                                                       : kOccupiedCell;
        });
  }
  return message;
}

Path path_message(std::uint64_t time_ns, const std::vector<pipeline::StampedPose>& trajectory) {
  Path path;
  path.header = header_of(time_ns, kMapFrame);
  geometry::Pose2 T_map_last;
  for (const pipeline::StampedPose& pose : trajectory) {
    if (path.poses.empty() || is_a_step(T_map_last, pose.T_map_robot)) {
      T_map_last = pose.T_map_robot;
      path.poses.push_back({header_of(time_ns, kMapFrame), pose_of(T_map_last)});
    }
  }
  return path;
}

PoseWithCovarianceStamped pose_message(std::uint64_t time_ns, const pipeline::Snapshot& snapshot) {
  PoseWithCovarianceStamped message;
  message.header = header_of(time_ns, kMapFrame);
  message.pose.pose = pose_of(snapshot.latest.T_map_robot);
  const double stddev_m = snapshot.position_stddev_m.value_or(0.0);
  message.pose.covariance[0] = stddev_m * stddev_m;
  message.pose.covariance[7] = stddev_m * stddev_m;
  return message;
}

std::optional<LaserScan> scan_message(std::uint64_t time_ns,
                                      const mapping::Scan& scan,
                                      const geometry::Pose2& T_map_robot,
                                      double max_range_m) {
  LaserScan message;
  message.header = header_of(time_ns, kRobotFrame);
  const double step_rad = 2.0 * std::numbers::pi / kScanBearings;
  message.angle_min = static_cast<float>(-std::numbers::pi);
  message.angle_increment = static_cast<float>(step_rad);
  message.angle_max = static_cast<float>(std::numbers::pi - step_rad);
  message.range_max = static_cast<float>(max_range_m);
  message.ranges.assign(kScanBearings, std::numeric_limits<float>::infinity());
  const geometry::Pose2 T_robot_map = T_map_robot.inverse();
  bool is_empty = true;
  for (const mapping::PlacedReading& reading : scan) {
    if (const auto echo_m = mapping::echo_point_m(reading)) {
      const Eigen::Vector2d seen_m = T_robot_map * *echo_m;
      const double bearing_rad = std::atan2(seen_m.y(), seen_m.x());
      const auto index =
          static_cast<std::size_t>(std::lround((bearing_rad + std::numbers::pi) / step_rad));
      float& range = message.ranges[index % kScanBearings];
      range = std::min(range, static_cast<float>(seen_m.norm()));
      is_empty = false;
    }
  }
  return is_empty ? std::nullopt : std::optional(message);
}

MarkerArray features_message(std::uint64_t time_ns,
                             const mapping::SonarFeatures& features,
                             const std::optional<mapping::PolygonMap>& outline) {
  constexpr ColorRGBA kWall{0.80F, 0.47F, 0.65F, 1.0F};
  constexpr ColorRGBA kOutline{0.0F, 0.62F, 0.45F, 1.0F};
  MarkerArray message;
  message.markers.reserve(3 + features.circles.size());
  message.markers.push_back(line_marker(time_ns, "", Marker::kLineList, kWall));
  message.markers.back().action = Marker::kDeleteAll;
  Marker walls = line_marker(time_ns, "walls", Marker::kLineList, kWall);
  walls.points.reserve(2 * features.walls.size());
  for (const geometry::Segment& wall : features.walls) {
    walls.points.push_back(point_of(wall.from_m));
    walls.points.push_back(point_of(wall.to_m));
  }
  message.markers.push_back(std::move(walls));
  for (const mapping::FittedCircle& circle : features.circles) {
    geometry::Polygon rim_m;
    rim_m.reserve(mapping::FittedCircle::kSectors);
    for (std::size_t i = 0; i < mapping::FittedCircle::kSectors; ++i) {
      rim_m.push_back(circle.rim_m(i));
    }
    const auto id = static_cast<std::int32_t>(message.markers.size());
    message.markers.push_back(ring_marker(time_ns, "obstacles", id, rim_m, kWall));
  }
  if (outline) {
    message.markers.push_back(ring_marker(time_ns, "outline", 0, outline->outline_m(), kOutline));
  }
  return message;
}

PoseArray particles_message(std::uint64_t time_ns,
                            const std::vector<geometry::Pose2>& T_map_robots) {
  PoseArray message;
  message.header = header_of(time_ns, kMapFrame);
  message.poses.reserve(T_map_robots.size());
  std::transform(
      T_map_robots.begin(), T_map_robots.end(), std::back_inserter(message.poses), &pose_of);
  return message;
}

}  // namespace echomap::recording
