// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "host/ros_messages/geometry_msgs.hpp"

namespace echomap::ros_messages {

/// Transforms between frames: on `/tf` those that change, on `/tf_static` those that hold for good.
struct TFMessage {
  static constexpr std::string_view kName = "tf2_msgs/msg/TFMessage";
  std::vector<TransformStamped> transforms;
  bool operator==(const TFMessage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("transforms", self.transforms);
  }
};

}  // namespace echomap::ros_messages
