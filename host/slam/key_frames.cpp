// SPDX-License-Identifier: MIT
#include "host/slam/key_frames.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

std::size_t KeyFrames::add(const geometry::Pose2& T_map_frame, KeyFrame frame) {
  frames_.push_back(std::move(frame));
  neighbours_.emplace_back();
  return graph_.add_node(T_map_frame);
}

void KeyFrames::join(const PoseEdge& edge) {
  graph_.add_edge(edge);
  add_neighbours(edge);
}

bool KeyFrames::close_loops(std::span<const PoseEdge> loops) {
  PoseGraph closed = graph_;
  for (const PoseEdge& loop : loops) {
    closed.add_edge(loop);
  }
  if (!closed.solve()) {
    return false;
  }
  graph_ = std::move(closed);
  for (const PoseEdge& loop : loops) {
    add_neighbours(loop);
  }
  return true;
}

void KeyFrames::add_neighbours(const PoseEdge& edge) {
  const double length_m = edge.T_from_to.position_m().norm();
  neighbours_[edge.from].push_back({edge.to, length_m});
  neighbours_[edge.to].push_back({edge.from, length_m});
}

std::vector<NearFrame> KeyFrames::near(std::size_t from, double max_m) const {
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  std::vector<double> shortest_m(frames_.size(), std::numeric_limits<double>::infinity());
  std::vector<NearFrame> near;
  shortest_m[from] = 0.0;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [travelled_m, frame] = open.top();
    open.pop();
    if (travelled_m > shortest_m[frame]) {
      continue;
    }
    near.push_back({frame, travelled_m});
    for (const Neighbour& neighbour : neighbours_[frame]) {
      const double through_m = travelled_m + neighbour.length_m;
      if (through_m <= max_m && through_m < shortest_m[neighbour.to]) {
        shortest_m[neighbour.to] = through_m;
        open.emplace(through_m, neighbour.to);
      }
    }
  }
  return near;
}

std::vector<Eigen::Vector2d> KeyFrames::map_points_m(std::size_t number) const {
  return sensors::in_frame_a_m(T_map_frame(number), frames_[number].points_m);
}

}  // namespace echomap::slam
