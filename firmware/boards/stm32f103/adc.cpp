// SPDX-License-Identifier: MIT
#include "firmware/hal/adc.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/registers.hpp"

namespace echomap {
namespace boards {

/// The calibration takes 83 cycles of the converter, some 500 of the core; QEMU has no converter.
void start_converter() {
  constexpr uint32_t kChannelsOf55Cycles = 0x2DB6DB6D;  // 101 for each of channels 0 to 9.
  adc1().smpr2 = kChannelsOf55Cycles;
  adc1().cr2 = kAdcCr2On;
  const uint32_t start = now_half_us();
  while (now_half_us() - start < 4) {  // 1 us until it is stable, and 2 of its own cycles.
  }
  adc1().cr2 = kAdcCr2On | kAdcCr2Calibrate;
  for (uint16_t polls = 1000; polls != 0 && (adc1().cr2 & kAdcCr2Calibrate) != 0; --polls) {
  }
}

}  // namespace boards

namespace hal {

/// 68 cycles of 12 MHz: 6 us. The supply of 3.3 V is the reference.
void start_conversion(uint8_t aux_pin) {
  using namespace boards;
  adc1().sr = 0;
  adc1().sqr3 = converter_channel(aux_pin);
  adc1().cr2 = kAdcCr2On | kAdcCr2StartBySoftware | kAdcCr2Start;
}

bool conversion_done(uint16_t& value) {
  if ((boards::adc1().sr & boards::kAdcSrDone) == 0) {
    return false;
  }
  value = static_cast<uint16_t>(boards::adc1().dr >> 2);  // Of 12 bits; clears the flag.
  return true;
}

}  // namespace hal
}  // namespace echomap
