// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/geometry_msgs.hpp"

namespace echomap::ros_messages {

/// Where a robot is by its odometry, and how fast. The pose is in the header's frame, the velocity
/// in the child frame.
struct Odometry {
  static constexpr std::string_view kName = "nav_msgs/msg/Odometry";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;
  bool operator==(const Odometry&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("pose", self.pose);
    visit("twist", self.twist);
  }
};

/// Poses in the order in which a robot was there, or is to be.
struct Path {
  static constexpr std::string_view kName = "nav_msgs/msg/Path";
  Header header;
  std::vector<PoseStamped> poses;
  bool operator==(const Path&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("poses", self.poses);
  }
};

/// Size and place of a grid.
struct MapMetaData {
  static constexpr std::string_view kName = "nav_msgs/msg/MapMetaData";
  Time map_load_time;
  float resolution = 0.0F;  ///< Edge of a cell, metres.
  std::uint32_t width = 0;  ///< Cells along x.
  std::uint32_t height = 0;
  Pose origin;  ///< Of the corner of the first cell, in the frame of the map.
  bool operator==(const MapMetaData&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("map_load_time", self.map_load_time);
    visit("resolution", self.resolution);
    visit("width", self.width);
    visit("height", self.height);
    visit("origin", self.origin);
  }
};

/// A grid of probabilities that a cell is occupied.
struct OccupancyGrid {
  static constexpr std::string_view kName = "nav_msgs/msg/OccupancyGrid";
  static constexpr std::int8_t kUnknown = -1;
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;  ///< Percent, or unknown; along x first, then along y.
  bool operator==(const OccupancyGrid&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("info", self.info);
    visit("data", self.data);
  }
};

}  // namespace echomap::ros_messages
