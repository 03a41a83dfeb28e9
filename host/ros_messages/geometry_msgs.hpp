// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/std_msgs.hpp"

namespace echomap::ros_messages {

/// A point, metres.
struct Point {
  static constexpr std::string_view kName = "geometry_msgs/msg/Point";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  bool operator==(const Point&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
  }
};

/// A direction and magnitude: a translation in metres, a velocity in metres or radians a second.
struct Vector3 {
  static constexpr std::string_view kName = "geometry_msgs/msg/Vector3";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  bool operator==(const Vector3&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
  }
};

/// A rotation as a unit quaternion.
struct Quaternion {
  static constexpr std::string_view kName = "geometry_msgs/msg/Quaternion";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
  bool operator==(const Quaternion&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
    visit("w", self.w);
  }
};

/// A position and orientation in space.
struct Pose {
  static constexpr std::string_view kName = "geometry_msgs/msg/Pose";
  Point position;
  Quaternion orientation;
  bool operator==(const Pose&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("position", self.position);
    visit("orientation", self.orientation);
  }
};

/// A position and heading in the plane, metres and radians.
struct Pose2D {
  static constexpr std::string_view kName = "geometry_msgs/msg/Pose2D";
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
  bool operator==(const Pose2D&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("theta", self.theta);
  }
};

/// A pose at an instant in a named frame.
struct PoseStamped {
  static constexpr std::string_view kName = "geometry_msgs/msg/PoseStamped";
  Header header;
  Pose pose;
  bool operator==(const PoseStamped&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("pose", self.pose);
  }
};

/// A pose with its 6 x 6 covariance, row by row: x, y, z, then rotations about x, y, z.
struct PoseWithCovariance {
  static constexpr std::string_view kName = "geometry_msgs/msg/PoseWithCovariance";
  Pose pose;
  std::array<double, 36> covariance{};
  bool operator==(const PoseWithCovariance&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("pose", self.pose);
    visit("covariance", self.covariance);
  }
};

/// A pose with covariance at an instant in a named frame, as an estimator of the pose publishes it.
struct PoseWithCovarianceStamped {
  static constexpr std::string_view kName = "geometry_msgs/msg/PoseWithCovarianceStamped";
  Header header;
  PoseWithCovariance pose;
  bool operator==(const PoseWithCovarianceStamped&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("pose", self.pose);
  }
};

/// Poses of one instant in one frame, as the particles of a filter.
struct PoseArray {
  static constexpr std::string_view kName = "geometry_msgs/msg/PoseArray";
  Header header;
  std::vector<Pose> poses;
  bool operator==(const PoseArray&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("poses", self.poses);
  }
};

/// The pose of a child frame in its parent frame.
struct Transform {
  static constexpr std::string_view kName = "geometry_msgs/msg/Transform";
  Vector3 translation;
  Quaternion rotation;
  bool operator==(const Transform&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("translation", self.translation);
    visit("rotation", self.rotation);
  }
};

/// A transform with the names of both frames; the header's frame is the parent.
struct TransformStamped {
  static constexpr std::string_view kName = "geometry_msgs/msg/TransformStamped";
  Header header;
  std::string child_frame_id;
  Transform transform;
  bool operator==(const TransformStamped&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("transform", self.transform);
  }
};

/// Velocities along and about the axes, metres and radians a second.
struct Twist {
  static constexpr std::string_view kName = "geometry_msgs/msg/Twist";
  Vector3 linear;
  Vector3 angular;
  bool operator==(const Twist&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("linear", self.linear);
    visit("angular", self.angular);
  }
};

/// Velocities with their 6 x 6 covariance, row by row: along x, y, z, then about x, y, z.
struct TwistWithCovariance {
  static constexpr std::string_view kName = "geometry_msgs/msg/TwistWithCovariance";
  Twist twist;
  std::array<double, 36> covariance{};
  bool operator==(const TwistWithCovariance&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("twist", self.twist);
    visit("covariance", self.covariance);
  }
};

}  // namespace echomap::ros_messages
