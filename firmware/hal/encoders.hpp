// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Levels of the encoder pins now, bits as in `on_encoder_pins`.
uint8_t encoder_levels();

}  // namespace hal
}  // namespace echomap
