// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Up to eight contacts or detectors. What one shows counts at once, and until it has not shown it
/// in a whole window of kReleaseMs, that is for kReleaseMs to kMaxReleaseMs: contacts bounce, and
/// beams flicker at an edge. None keeps another active.
class DebouncedBits {
 public:
  static constexpr uint8_t kReleaseMs = 20;
  static constexpr uint8_t kMaxReleaseMs = 2 * kReleaseMs;

  /// Takes what is shown now; once a millisecond.
  void update(uint8_t shown);

  uint8_t active() const { return active_; }
  /// Those that began with the last update.
  uint8_t fresh() const { return fresh_; }

 private:
  uint8_t active_ = 0;
  uint8_t fresh_ = 0;
  uint8_t seen_ = 0;         ///< In the window under way,
  uint8_t seen_before_ = 0;  ///< and in the one before it.
  uint8_t window_ms_ = 0;
};

}  // namespace drivers
}  // namespace echomap
