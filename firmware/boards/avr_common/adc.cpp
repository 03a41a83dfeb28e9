// SPDX-License-Identifier: MIT
#include "firmware/hal/adc.hpp"

#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace hal {

/// 125 kHz: 104 us, the first one 200 us. The supply is the reference.
void start_conversion(uint8_t aux_pin) {
  const uint8_t channel = boards::converter_channel(aux_pin);
  ADMUX = static_cast<uint8_t>(_BV(REFS0) | (channel & 0x07));
#if defined(MUX5)
  ADCSRB = (channel & 0x08) != 0 ? _BV(MUX5) : 0;
#endif
  ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
}

bool conversion_done(uint16_t& value) {
  if ((ADCSRA & _BV(ADSC)) != 0) {
    return false;
  }
  value = ADC;
  return true;
}

}  // namespace hal
}  // namespace echomap
