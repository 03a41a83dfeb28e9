// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/recording/session_recorder.hpp"
#include "host/robot_link/link_statistics.hpp"

namespace echomap::session {

/// Records the frames on a robot's line, and which of them the host took for observations. Without
/// a recorder it does nothing but hand on.
class LineRecorder {
 public:
  /// `recorder` outlives this; null for none.
  explicit LineRecorder(recording::SessionRecorder* recorder) : recorder_(recorder) {}

  /// All that follows happens at this instant.
  void set_time(time::HostTime now);
  void sent(std::span<const std::uint8_t> bytes);
  /// Hands the bytes to `take`, one frame at a time.
  void receive(std::span<const std::uint8_t> bytes,
               const std::function<void(std::span<const std::uint8_t>)>& take);
  /// Called from within `take`: what the frame says, with this stamp, is an observation.
  void use(std::uint32_t robot_stamp_us) { used_stamp_us_ = robot_stamp_us; }
  void record(const recording::SessionEvent& event);
  void record(const robot_link::LinkStatistics& link);

 private:
  recording::SessionRecorder* recorder_;
  std::vector<std::uint8_t> received_;          ///< What has come of a frame.
  std::optional<std::uint32_t> used_stamp_us_;  ///< Of the frame, where it was an observation.
};

}  // namespace echomap::session
