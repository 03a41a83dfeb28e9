// SPDX-License-Identifier: MIT
#include "firmware/hal/adc.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/registers.hpp"

namespace echomap {
namespace boards {

void start_converter() { adc().cs = kAdcEnable; }

}  // namespace boards

namespace hal {

/// 96 cycles of 48 MHz: 2 us. The supply of 3.3 V is the reference.
void start_conversion(uint8_t aux_pin) {
  using namespace boards;
  adc().cs = uint32_t{converter_channel(aux_pin)} << kAdcChannelShift | kAdcStart | kAdcEnable;
}

bool conversion_done(uint16_t& value) {
  if ((boards::adc().cs & boards::kAdcReady) == 0) {
    return false;
  }
  value = static_cast<uint16_t>(boards::adc().result >> 2);  // Of 12 bits.
  return true;
}

}  // namespace hal
}  // namespace echomap
