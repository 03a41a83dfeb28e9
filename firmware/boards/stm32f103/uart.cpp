// SPDX-License-Identifier: MIT
#include "firmware/hal/uart.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kBaud = ECHOMAP_BAUD;
constexpr uint32_t kAlwaysOn =
    kUsartCr1Enable | kUsartCr1Sender | kUsartCr1Receiver | kUsartCr1ReceivedInterrupt;

void receive() {
  const uint32_t status = usart1().sr;
  if ((status & (kUsartSrReceived | kUsartSrOverrun)) == 0) {
    return;
  }
  const uint8_t byte = static_cast<uint8_t>(usart1().dr);  // Clears both.
  if ((status & kUsartSrOverrun) != 0) {
    hal::on_receive_overrun();
  }
  if ((status & kUsartSrReceived) != 0) {
    hal::on_byte_received(byte);
  }
}

void send() {
  uint8_t byte = 0;
  while ((usart1().sr & kUsartSrSendEmpty) != 0) {
    if (!hal::next_byte_to_send(byte)) {
      usart1().cr1 = kAlwaysOn;
      return;
    }
    usart1().dr = byte;
  }
}

}  // namespace

void start_uart() {
  set_level(kSendPin, true);
  set_mode(kSendPin, PinMode::kAlternate);
  pull_up(kReceivePin);
  usart1().brr = (clock_hz() + kBaud / 2) / kBaud;
  usart1().cr1 = kAlwaysOn;
  enable_line(InterruptLine::kUsart1, kEventPriority);
}

}  // namespace boards

namespace hal {

uint16_t line_bytes_per_s() {
  static_assert(boards::kBaud / 10 <= UINT16_MAX, "faster than a number of 16 bits");
  return boards::kBaud / 10;
}

/// The interrupt is asked for by hand as well, because QEMU 7.2 has none for an empty sender.
void request_send() {
  boards::usart1().cr1 = boards::kAlwaysOn | boards::kUsartCr1SendEmptyInterrupt;
  boards::pend_line(boards::InterruptLine::kUsart1);
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_usart1() {
  echomap::boards::receive();
  echomap::boards::send();
}
