// SPDX-License-Identifier: MIT
#include "firmware/drivers/debounced_bits.hpp"

#include "firmware/hal/code_size.hpp"

namespace echomap {
namespace drivers {

ECHOMAP_ONE_PIECE void DebouncedBits::update(uint8_t shown) {
  fresh_ = shown & static_cast<uint8_t>(~active_);
  active_ |= shown;
  if (shown != shown_) {
    shown_ = shown;
    steady_ms_ = 0;
  }
  if (++steady_ms_ >= kReleaseMs) {
    steady_ms_ = kReleaseMs;
    active_ = shown;
  }
}

}  // namespace drivers
}  // namespace echomap
