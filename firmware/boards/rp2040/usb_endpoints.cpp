// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/usb_endpoints.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/usb_line.hpp"
#include "firmware/boards/rp2040/usb_protocol.hpp"
#include "firmware/boards/rp2040/usb_registers.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kInterruptType = 3;
constexpr uint32_t kBulkType = 2;
/// One less than the endpoint takes: a host that has asked for more than one packet waits for one
/// that is not full.
constexpr uint8_t kSentAtOnce = usb::kBulkPacketBytes - 1;

bool sending = false;
bool packet_taken = false;  ///< The host may send the next one.
uint32_t send_data_bit = 0;
uint32_t receive_data_bit = 0;

EndpointPair& data_buffers() { return usb_memory().buffer[usb::kDataEndpoint]; }

constexpr uint32_t control_of(uint32_t type, uint32_t buffer) {
  return kEndpointEnable | kEndpointInterrupt | type << kEndpointTypeShift | buffer;
}

void receive_next() {
  packet_taken = false;
  give_to_usb(data_buffers().out, receive_data_bit | usb::kBulkPacketBytes);
}

}  // namespace

volatile uint8_t* usb_buffer(uint32_t offset) {
  return &block_at<volatile uint8_t>(kUsbMemoryAddress + offset);
}

/// 4.1.2.5.1: the rest must be there a cycle of the slower clock before the buffer is given away.
void give_to_usb(volatile uint32_t& buffer, uint32_t state) {
  buffer = state;
  asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop");
  buffer = state | kBufferAvailable;
}

void start_usb_endpoints() {
  EndpointPair* const control = usb_memory().control;
  control[usb::kNotificationEndpoint - 1].in = control_of(kInterruptType, kNotificationBuffer);
  control[usb::kDataEndpoint - 1].in = control_of(kBulkType, kSendBuffer);
  control[usb::kDataEndpoint - 1].out = control_of(kBulkType, kReceiveBuffer);
  usb_memory().buffer[usb::kNotificationEndpoint].in = 0;
  halt_usb_endpoint(usb::kToHost | usb::kDataEndpoint, false);
  halt_usb_endpoint(usb::kDataEndpoint, false);
}

void stop_usb_endpoints() {
  usb_memory().control[usb::kNotificationEndpoint - 1].in = 0;
  usb_memory().control[usb::kDataEndpoint - 1].in = 0;
  usb_memory().control[usb::kDataEndpoint - 1].out = 0;
  data_buffers().in = 0;
  data_buffers().out = 0;
  sending = false;
  packet_taken = false;
}

void halt_usb_endpoint(uint8_t endpoint, bool halted) {
  const uint32_t state = halted ? kBufferStall : 0;
  if (endpoint == (usb::kToHost | usb::kNotificationEndpoint)) {
    usb_memory().buffer[usb::kNotificationEndpoint].in = state;
  } else if (endpoint == (usb::kToHost | usb::kDataEndpoint)) {
    data_buffers().in = state;
    sending = halted;
    send_data_bit = 0;
    pend_line(InterruptLine::kSend);
  } else {
    data_buffers().out = state;
    receive_data_bit = 0;
    packet_taken = !halted;
  }
}

void on_usb_packet_sent() {
  sending = false;
  send_data_bit ^= kBufferData1;
  send_over_usb();
}

void on_usb_packet_received() {
  const uint8_t size = static_cast<uint8_t>(data_buffers().out & kBufferLength);
  receive_data_bit ^= kBufferData1;
  packet_taken = true;
  if (!usb_line_is_open()) {
    return;
  }
  const volatile uint8_t* const bytes = usb_buffer(kReceiveBuffer);
  for (uint8_t i = 0; i < size; ++i) {
    hal::on_byte_received(bytes[i]);
  }
}

void send_over_usb() {
  if (sending || !usb_line_is_open()) {
    return;
  }
  volatile uint8_t* const bytes = usb_buffer(kSendBuffer);
  uint8_t size = 0;
  uint8_t byte = 0;
  while (size < kSentAtOnce && hal::next_byte_to_send(byte)) {
    bytes[size] = byte;
    ++size;
  }
  if (size != 0) {
    sending = true;
    give_to_usb(data_buffers().in, kBufferFull | send_data_bit | size);
  }
}

void take_next_usb_packet() {
  if (packet_taken) {
    receive_next();
  }
}

}  // namespace boards
}  // namespace echomap
