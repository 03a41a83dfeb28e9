// SPDX-License-Identifier: MIT
#include "host/datasets/transform_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace echomap::datasets {

SpatialPose SpatialPose::operator*(const SpatialPose& T_b_c) const {
  return {position_m + rotation * T_b_c.position_m, (rotation * T_b_c.rotation).normalized()};
}

void TransformTree::add_static(const std::string& parent,
                               const std::string& child,
                               const SpatialPose& T_p_c) {
  frames_[child] = {parent, true, {{0.0, T_p_c}}};
}

void TransformTree::add(const std::string& parent,
                        const std::string& child,
                        double stamp_s,
                        const SpatialPose& T_p_c) {
  Frame& frame = frames_[child];
  if (frame.is_static || frame.parent != parent) {
    frame = {parent, false, {}};
  }
  const auto after = std::upper_bound(
      frame.samples.begin(),
      frame.samples.end(),
      stamp_s,
      [](double instant_s, const Sample& sample) { return instant_s < sample.stamp_s; });
  frame.samples.insert(after, {stamp_s, T_p_c});
  while (frame.samples.front().stamp_s < frame.samples.back().stamp_s - kHistoryS) {
    frame.samples.pop_front();
  }
}

std::optional<SpatialPose> TransformTree::Frame::at(double stamp_s) const {
  const auto after = std::upper_bound(
      samples.begin(), samples.end(), stamp_s, [](double instant_s, const Sample& sample) {
        return instant_s < sample.stamp_s;
      });
  if (after == samples.begin()) {
    const bool is_near = is_static || stamp_s >= after->stamp_s - kMaxBackS;
    return is_near ? std::optional(after->T_p_c) : std::nullopt;
  }
  const Sample& from = *std::prev(after);
  if (after == samples.end()) {
    return from.T_p_c;
  }
  const double share = (stamp_s - from.stamp_s) / (after->stamp_s - from.stamp_s);
  return SpatialPose{
      from.T_p_c.position_m + share * (after->T_p_c.position_m - from.T_p_c.position_m),
      from.T_p_c.rotation.slerp(share, after->T_p_c.rotation)};
}

std::optional<SpatialPose> TransformTree::find(const std::string& target,
                                               const std::string& frame,
                                               double stamp_s) const {
  SpatialPose T_name_frame;
  std::string name = frame;
  // A chain that is longer than there are frames runs in a circle.
  for (std::size_t steps = 0; steps <= frames_.size(); ++steps) {
    if (name == target) {
      return T_name_frame;
    }
    const auto found = frames_.find(name);
    if (found == frames_.end()) {
      return std::nullopt;
    }
    const auto T_p_c = found->second.at(stamp_s);
    if (!T_p_c) {
      return std::nullopt;
    }
    T_name_frame = *T_p_c * T_name_frame;
    name = found->second.parent;
  }
  return std::nullopt;
}

}  // namespace echomap::datasets
