// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "hil_mock/line_faults/delay_model.hpp"

namespace echomap::line_faults {

/// One direction of a line that delays frames, told apart by the zero that ends each: the bytes of
/// a frame keep the distance at which they were sent, unless the frame before holds them up.
class DelayedLine {
 public:
  DelayedLine(const DelayParams& params, world::NoiseStream noise) : model_(params, noise) {}

  /// `now_ns` never goes back.
  void send(std::uint8_t byte, std::int64_t now_ns);
  /// When the next byte arrives; empty where none is on its way.
  std::optional<std::int64_t> next_arrival_ns() const;
  /// The bytes that have arrived by `now_ns`.
  std::vector<std::uint8_t> take_arrived(std::int64_t now_ns);

 private:
  struct OnItsWay {
    std::int64_t arrival_ns;
    std::uint8_t byte;
  };

  DelayModel model_;
  std::deque<OnItsWay> bytes_;
  std::int64_t frame_delay_ns_ = 0;
  std::int64_t last_arrival_ns_ = 0;
  bool in_frame_ = false;
};

}  // namespace echomap::line_faults
