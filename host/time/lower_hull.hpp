// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace echomap::time {

/// One instant on both clocks, in microseconds of each.
struct ClockPoint {
  std::int64_t robot_us = 0;
  std::int64_t host_us = 0;
};

/// Of `point` over the line of this rate through `origin`, in microseconds of the host.
double height_over(const ClockPoint& origin, double rate, const ClockPoint& point);

/// The lower convex hull of points that come in the order of the robot's clock (Andrew's monotone
/// chain, 1979). O(1) amortized for a point.
class LowerHull {
 public:
  /// `point` lies after all others on the robot's clock.
  void add(const ClockPoint& point);
  /// Adds the points of a hull that lies after this one.
  void append(const LowerHull& later);

  /// The point that a line of this rate from below touches first; O(log n). Not for an empty hull.
  const ClockPoint& touched_by(double rate) const;
  const std::vector<ClockPoint>& vertices() const { return vertices_; }

 private:
  std::vector<ClockPoint> vertices_;  ///< The first and the last point are always among them.
};

/// The lower hull of the last points. It forgets in blocks of 1/128 of the window, each with a hull
/// of its own, so that the hull of all costs the few points that stand in those.
class SlidingLowerHull {
 public:
  /// `window_us` on the robot's clock.
  explicit SlidingLowerHull(std::int64_t window_us) : block_us_(window_us / kBlocks) {}

  /// A point that does not lie after all others is left out: it was longer under way than the later
  /// one that overtook it, so the hull does not need it.
  void add(const ClockPoint& point);
  void clear() { blocks_.clear(); }
  bool empty() const { return blocks_.empty(); }
  /// The hull of all points in the window.
  LowerHull hull() const;
  /// How far, in microseconds, the lowest point over a line of this rate is likely to lie above the
  /// lowest there can be: the mean height of the blocks' lowest points, taken from their median,
  /// divided by their number. For independent delays that is the mean of all divided by the number
  /// of all; where neighbours are alike, as in a beat of two clocks, it is more, and rightly.
  double expected_excess_us(double rate) const;

 private:
  static constexpr int kBlocks = 128;
  /// Bounds the memory; random delays leave about ten vertices in a block.
  static constexpr std::size_t kMaxBlockVertices = 256;

  struct Block {
    std::int64_t begin_us;
    LowerHull hull;
  };

  std::int64_t block_us_;
  std::deque<Block> blocks_;
};

}  // namespace echomap::time
