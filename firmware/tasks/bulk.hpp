// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/tasks/frame_sender.hpp"
#include "protocol/configuration.hpp"

namespace echomap {
namespace tasks {

/// Answers BulkRead when the line has nothing better to do. It remembers what was asked and nothing
/// else; what finds no place, or an answer that gets lost, the host asks again.
class Bulk {
 public:
  /// Requests that may wait, as many as a host has open.
  static constexpr uint8_t kWindow = 4;

  constexpr Bulk(FrameSender& sender, const protocol::Configuration& configuration)
      : sender_(sender), configuration_(configuration) {}

  void ask(const protocol::BulkRead& read);
  /// Once a millisecond, after telemetry.
  void tick();

 private:
  void answer_oldest();

  FrameSender& sender_;
  const protocol::Configuration& configuration_;
  protocol::BulkRead asked_[kWindow] = {};
  uint8_t waiting_ = 0;
};

}  // namespace tasks
}  // namespace echomap
