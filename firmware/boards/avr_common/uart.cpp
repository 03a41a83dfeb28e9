// SPDX-License-Identifier: MIT
#include "firmware/boards/avr_common/uart.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/hal/events.hpp"
#include "firmware/hal/uart.hpp"

// A chip with several USARTs numbers their vectors.
#if defined(USART0_RX_vect)
#define ECHOMAP_RECEIVED_vect USART0_RX_vect
#define ECHOMAP_EMPTY_vect USART0_UDRE_vect
#else
#define ECHOMAP_RECEIVED_vect USART_RX_vect
#define ECHOMAP_EMPTY_vect USART_UDRE_vect
#endif

#ifndef ECHOMAP_BAUD  // The Arduino IDE defines nothing of ours.
#define ECHOMAP_BAUD 250000UL
#endif

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kBaud = ECHOMAP_BAUD;
constexpr uint16_t kDivider = (F_CPU + 4 * kBaud) / (8 * kBaud);
constexpr uint32_t kActualBaud = F_CPU / (8UL * kDivider);
constexpr uint32_t kErrorBaud = kActualBaud > kBaud ? kActualBaud - kBaud : kBaud - kActualBaud;
static_assert(kErrorBaud * 1000 <= kBaud * 25, "the baud rate is more than 2.5 % off");

constexpr uint8_t kAlwaysOn = _BV(RXCIE0) | _BV(RXEN0) | _BV(TXEN0);

}  // namespace

void start_uart() {
  UCSR0A = _BV(U2X0);  // Before UBRR0: simavr takes the rate from it when UBRR0 is written.
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
  UBRR0 = kDivider - 1;
  UCSR0B = kAlwaysOn;
}

}  // namespace boards

namespace hal {

uint16_t line_bytes_per_s() {
  static_assert(boards::kActualBaud / 10 <= UINT16_MAX, "faster than a number of 16 bits");
  return boards::kActualBaud / 10;
}

void request_send() { UCSR0B = boards::kAlwaysOn | _BV(UDRIE0); }

ISR(ECHOMAP_RECEIVED_vect) {
  const uint8_t status = UCSR0A;
  const uint8_t byte = UDR0;
  if ((status & _BV(DOR0)) != 0) {
    on_receive_overrun();
  }
  on_byte_received(byte);
}

ISR(ECHOMAP_EMPTY_vect) {
  uint8_t byte = 0;
  if (next_byte_to_send(byte)) {
    UDR0 = byte;
  } else {
    UCSR0B = boards::kAlwaysOn;
  }
}

}  // namespace hal
}  // namespace echomap
