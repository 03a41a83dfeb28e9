// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Up to eight contacts or detectors. What one shows counts at once, its end when nothing has
/// changed for kReleaseMs: contacts bounce, and beams flicker at an edge.
class DebouncedBits {
 public:
  static constexpr uint8_t kReleaseMs = 20;

  /// Takes what is shown now; once a millisecond.
  void update(uint8_t shown);

  uint8_t active() const { return active_; }
  /// Those that began with the last update.
  uint8_t fresh() const { return fresh_; }

 private:
  uint8_t active_ = 0;
  uint8_t fresh_ = 0;
  uint8_t shown_ = 0;
  uint8_t steady_ms_ = 0;
};

}  // namespace drivers
}  // namespace echomap
