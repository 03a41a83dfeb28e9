// SPDX-License-Identifier: MIT
#include "firmware/drivers/debounced_bits.hpp"

namespace echomap {
namespace drivers {

void DebouncedBits::update(uint8_t shown) {
  fresh_ = shown & static_cast<uint8_t>(~active_);
  if (++window_ms_ == kReleaseMs) {
    window_ms_ = 0;
    seen_before_ = seen_;
    seen_ = 0;
  }
  seen_ |= shown;
  active_ = seen_ | seen_before_;
}

}  // namespace drivers
}  // namespace echomap
