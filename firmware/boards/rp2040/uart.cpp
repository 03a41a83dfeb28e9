// SPDX-License-Identifier: MIT
#include "firmware/hal/uart.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"
#include "firmware/boards/rp2040/usb_line.hpp"
#include "firmware/boards/rp2040/vectors.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kBaud = ECHOMAP_BAUD;
constexpr uint32_t kClockHz = 125000000;
/// 16 periods a bit, with six bits of fraction.
constexpr uint32_t kDivider = (kClockHz * 4 + kBaud / 2) / kBaud;
constexpr uint32_t kReceiveInterrupts = kUartReceived | kUartReceiveTimeout;

/// Half a FIFO of 32 bytes would wait too long for its other half.
void receive() {
  uart0().icr = kReceiveInterrupts;
  while ((uart0().fr & kUartFrReceiveEmpty) == 0) {
    const uint32_t received = uart0().dr;
    if (usb_line_is_open()) {
      continue;
    }
    if ((received & kUartDrOverrun) != 0) {
      hal::on_receive_overrun();
    }
    if ((received & kUartDrDamaged) == 0) {
      hal::on_byte_received(static_cast<uint8_t>(received));
    }
  }
}

/// Fills the FIFO; it asks for more once it has run nearly empty, not while it is.
void send() {
  uint8_t byte = 0;
  if (usb_line_is_open()) {
    uart0().imsc = kReceiveInterrupts;
    return;
  }
  uart0().icr = kUartSendLow;
  while ((uart0().fr & kUartFrSendFull) == 0) {
    if (!hal::next_byte_to_send(byte)) {
      uart0().imsc = kReceiveInterrupts;
      return;
    }
    uart0().dr = byte;
  }
  uart0().imsc = kReceiveInterrupts | kUartSendLow;
}

}  // namespace

void start_uart() {
  set_function(kSendPin, PinFunction::kUart);
  pull_up(kReceivePin);
  set_function(kReceivePin, PinFunction::kUart);
  uart0().ibrd = kDivider / 64;
  uart0().fbrd = kDivider % 64;
  uart0().lcr_h = kUartLcr8Bits | kUartLcrFifos;  // Takes over both halves of the divider.
  uart0().ifls = 0;                               // Both FIFOs at an eighth: four bytes.
  uart0().imsc = kReceiveInterrupts;
  uart0().cr = kUartCrEnable | kUartCrSender | kUartCrReceiver;
  enable_line(InterruptLine::kUart0);
  enable_line(InterruptLine::kSend);
}

}  // namespace boards

namespace hal {

uint16_t line_bytes_per_s() {
  static_assert(boards::kBaud / 10 <= UINT16_MAX, "faster than a number of 16 bits");
  return boards::usb_line_is_open() ? UINT16_MAX : boards::kBaud / 10;
}

void request_send() { boards::pend_line(boards::InterruptLine::kSend); }

}  // namespace hal
}  // namespace echomap

extern "C" {
void on_uart0() {
  echomap::boards::receive();
  echomap::boards::send();
}

void on_send() {
  echomap::boards::send_over_usb();
  echomap::boards::send();
}
}
