// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/sensor_msgs.hpp"

namespace echomap::ros_messages {

/// A place in a texture, 0 .. 1 along each edge.
struct UVCoordinate {
  static constexpr std::string_view kName = "visualization_msgs/msg/UVCoordinate";
  float u = 0.0F;
  float v = 0.0F;
  bool operator==(const UVCoordinate&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("u", self.u);
    visit("v", self.v);
  }
};

/// A mesh as the bytes of a file.
struct MeshFile {
  static constexpr std::string_view kName = "visualization_msgs/msg/MeshFile";
  std::string filename;
  std::vector<std::uint8_t> data;
  bool operator==(const MeshFile&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("filename", self.filename);
    visit("data", self.data);
  }
};

/// A shape that a viewer draws. This is the layout since ROS 2 Humble, with textures and meshes.
struct Marker {
  static constexpr std::string_view kName = "visualization_msgs/msg/Marker";
  static constexpr std::int32_t kArrow = 0;
  static constexpr std::int32_t kCube = 1;
  static constexpr std::int32_t kSphere = 2;
  static constexpr std::int32_t kCylinder = 3;
  static constexpr std::int32_t kLineStrip = 4;
  static constexpr std::int32_t kLineList = 5;
  static constexpr std::int32_t kCubeList = 6;
  static constexpr std::int32_t kSphereList = 7;
  static constexpr std::int32_t kPoints = 8;
  static constexpr std::int32_t kText = 9;  ///< Turned to the viewer.
  static constexpr std::int32_t kMesh = 10;
  static constexpr std::int32_t kTriangleList = 11;
  static constexpr std::int32_t kAdd = 0;  ///< Takes the place of the marker of that `ns` and `id`.
  static constexpr std::int32_t kDelete = 2;
  static constexpr std::int32_t kDeleteAll = 3;
  Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = kArrow;
  std::int32_t action = kAdd;
  Pose pose;
  Vector3 scale;
  ColorRGBA color;
  Duration lifetime;  ///< Zero: for good.
  bool frame_locked = false;
  std::vector<Point> points;  ///< In the frame of `pose`.
  std::vector<ColorRGBA> colors;
  std::string texture_resource;
  CompressedImage texture;
  std::vector<UVCoordinate> uv_coordinates;
  std::string text;
  std::string mesh_resource;
  MeshFile mesh_file;
  bool mesh_use_embedded_materials = false;
  bool operator==(const Marker&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("ns", self.ns);
    visit("id", self.id);
    visit("type", self.type);
    visit("action", self.action);
    visit("pose", self.pose);
    visit("scale", self.scale);
    visit("color", self.color);
    visit("lifetime", self.lifetime);
    visit("frame_locked", self.frame_locked);
    visit("points", self.points);
    visit("colors", self.colors);
    visit("texture_resource", self.texture_resource);
    visit("texture", self.texture);
    visit("uv_coordinates", self.uv_coordinates);
    visit("text", self.text);
    visit("mesh_resource", self.mesh_resource);
    visit("mesh_file", self.mesh_file);
    visit("mesh_use_embedded_materials", self.mesh_use_embedded_materials);
  }
};

/// Markers that a viewer shows at once.
struct MarkerArray {
  static constexpr std::string_view kName = "visualization_msgs/msg/MarkerArray";
  std::vector<Marker> markers;
  bool operator==(const MarkerArray&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("markers", self.markers);
  }
};

}  // namespace echomap::ros_messages
