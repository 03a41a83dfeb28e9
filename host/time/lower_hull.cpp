// SPDX-License-Identifier: MIT
#include "host/time/lower_hull.hpp"

#include <algorithm>
#include <numbers>

namespace echomap::time {
namespace {

/// Whether `middle` lies on or above the line from `left` to `right`.
bool is_above(const ClockPoint& middle, const ClockPoint& left, const ClockPoint& right) {
  return (middle.host_us - left.host_us) * (right.robot_us - left.robot_us) >=
         (right.host_us - left.host_us) * (middle.robot_us - left.robot_us);
}

double rate_between(const ClockPoint& left, const ClockPoint& right) {
  return static_cast<double>(right.host_us - left.host_us) /
         static_cast<double>(right.robot_us - left.robot_us);
}

}  // namespace

double height_over(const ClockPoint& origin, double rate, const ClockPoint& point) {
  return static_cast<double>(point.host_us - origin.host_us) -
         rate * static_cast<double>(point.robot_us - origin.robot_us);
}

void LowerHull::add(const ClockPoint& point) {
  while (vertices_.size() >= 2 && is_above(vertices_.back(), vertices_.end()[-2], point)) {
    vertices_.pop_back();
  }
  vertices_.push_back(point);
}

void LowerHull::append(const LowerHull& later) {
  for (const ClockPoint& point : later.vertices_) {
    add(point);
  }
}

const ClockPoint& LowerHull::touched_by(double rate) const {
  std::size_t first = 0;
  std::size_t last = vertices_.size() - 1;
  while (first < last) {
    const std::size_t middle = (first + last) / 2;
    if (rate_between(vertices_[middle], vertices_[middle + 1]) < rate) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return vertices_[first];
}

void SlidingLowerHull::add(const ClockPoint& point) {
  if (!blocks_.empty() && point.robot_us <= blocks_.back().hull.vertices().back().robot_us) {
    return;
  }
  const bool fits = !blocks_.empty() && point.robot_us - blocks_.back().begin_us < block_us_ &&
                    blocks_.back().hull.vertices().size() < kMaxBlockVertices;
  if (!fits) {
    blocks_.push_back({point.robot_us, {}});
  }
  blocks_.back().hull.add(point);
  while (blocks_.size() > kBlocks ||
         point.robot_us - blocks_.front().begin_us > kBlocks * block_us_) {
    blocks_.pop_front();
  }
}

LowerHull SlidingLowerHull::hull() const {
  LowerHull all;
  for (const Block& block : blocks_) {
    all.append(block.hull);
  }
  return all;
}

double SlidingLowerHull::expected_excess_us(double rate) const {
  const ClockPoint origin = blocks_.front().hull.touched_by(rate);
  std::vector<double> heights_us;
  heights_us.reserve(blocks_.size());
  for (const Block& block : blocks_) {
    heights_us.push_back(height_over(origin, rate, block.hull.touched_by(rate)));
  }
  std::ranges::sort(heights_us);
  const double median_us = heights_us[heights_us.size() / 2] - heights_us.front();
  return median_us / std::numbers::ln2 / static_cast<double>(heights_us.size());
}

}  // namespace echomap::time
