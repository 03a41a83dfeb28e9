// SPDX-License-Identifier: MIT
#include "firmware/drivers/serial_port.hpp"

#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/uart.hpp"

namespace echomap {
namespace drivers {

bool SerialPort::send(protocol::ByteSpan bytes) {
  if (sending_.room() < bytes.size) {
    return false;
  }
  for (uint8_t i = 0; i < bytes.size; ++i) {
    sending_.push(bytes.data[i]);
  }
  hal::request_send();
  return true;
}

uint16_t SerialPort::overruns() const {
  const hal::InterruptLock lock;
  return overruns_;
}

}  // namespace drivers
}  // namespace echomap
