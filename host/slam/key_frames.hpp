// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/pose_graph.hpp"

namespace echomap::slam {

/// A scan near a key frame.
struct FrameScan {
  geometry::Pose2 T_key_robot;
  sensors::RangeScan scan;
};

/// What was seen around one pose of the way.
struct KeyFrame {
  std::vector<Eigen::Vector2d> points_m;  ///< In the frame of the robot there.
  std::vector<FrameScan> scans;           ///< That the points are of.
};

/// A key frame and how long the shortest way to it is along the edges of the graph.
struct NearFrame {
  std::size_t frame = 0;
  double travelled_m = 0.0;
};

/// The key frames of a run, in the order of time, as nodes of a pose graph.
class KeyFrames {
 public:
  explicit KeyFrames(const PoseGraphParams& params = {}) : graph_(params) {}

  bool empty() const { return frames_.empty(); }
  std::size_t size() const { return frames_.size(); }
  const KeyFrame& frame(std::size_t number) const { return frames_[number]; }
  const geometry::Pose2& T_map_frame(std::size_t number) const { return graph_.nodes()[number]; }
  const PoseGraph& graph() const { return graph_; }

  std::size_t add(const geometry::Pose2& T_map_frame, KeyFrame frame);
  /// Throws std::invalid_argument for frames that are not there, or are one.
  void join(const PoseEdge& edge);
  /// Joins frames by loops as well and moves all to where the edges agree best. False where that
  /// cannot be solved: then all is as it was.
  bool close_loops(std::span<const PoseEdge> loops);

  /// The frames that can be reached from one by edges of so many metres together, itself first and
  /// in the order of the way (Dijkstra 1959). What was joined by a closed loop is near.
  std::vector<NearFrame> near(std::size_t from, double max_m) const;
  /// The points of a frame in the map.
  std::vector<Eigen::Vector2d> map_points_m(std::size_t number) const;

 private:
  struct Neighbour {
    std::size_t to = 0;
    double length_m = 0.0;
  };

  void add_neighbours(const PoseEdge& edge);

  PoseGraph graph_;
  std::vector<KeyFrame> frames_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

}  // namespace echomap::slam
