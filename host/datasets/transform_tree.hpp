// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace echomap::datasets {

/// Position and orientation of one frame in another, in space.
struct SpatialPose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();

  SpatialPose operator*(const SpatialPose& T_b_c) const;
};

/// The frames of a robot, each with its pose in its parent frame, as ROS keeps them.
class TransformTree {
 public:
  /// How much of the past of a moving frame is kept, seconds.
  static constexpr double kHistoryS = 10.0;
  /// How long before its first pose a moving frame is taken to be there already, seconds.
  static constexpr double kMaxBackS = 0.5;

  /// The pose of a frame that does not move in its parent.
  void add_static(const std::string& parent, const std::string& child, const SpatialPose& T_p_c);
  /// The pose of a frame at an instant. A frame that was static, or had another parent, begins
  /// again.
  void add(const std::string& parent,
           const std::string& child,
           double stamp_s,
           const SpatialPose& T_p_c);

  bool has(const std::string& child) const { return frames_.contains(child); }
  /// The pose of `frame` in `target` at an instant, along parents only. Between two poses of a
  /// moving frame it is interpolated, behind the last that holds. Empty where `target` is not above
  /// `frame`, or the instant is kMaxBackS before the first pose.
  std::optional<SpatialPose> find(const std::string& target,
                                  const std::string& frame,
                                  double stamp_s) const;

 private:
  struct Sample {
    double stamp_s = 0.0;
    SpatialPose T_p_c;
  };
  struct Frame {
    std::string parent;
    bool is_static = false;
    std::deque<Sample> samples;  ///< By stamp; never empty.

    std::optional<SpatialPose> at(double stamp_s) const;
  };

  std::map<std::string, Frame> frames_;  ///< By the name of the child.
};

}  // namespace echomap::datasets
