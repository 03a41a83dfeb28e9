// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/usb_control.hpp"
#include "firmware/boards/rp2040/usb_endpoints.hpp"
#include "firmware/boards/rp2040/usb_line.hpp"
#include "firmware/boards/rp2040/usb_registers.hpp"
#include "firmware/boards/rp2040/vectors.hpp"

/// Endpoint 0 and the events of the bus. What the host asks for is answered by usb_control.cpp.
namespace echomap {
namespace boards {
namespace {

/// Bits of BUFF_STATUS: two an endpoint, to the host first.
constexpr uint32_t kControlSent = bit(0);
constexpr uint32_t kControlReceived = bit(1);
constexpr uint32_t kDataSent = bit(2 * usb::kDataEndpoint);
constexpr uint32_t kDataReceived = bit(2 * usb::kDataEndpoint + 1);
constexpr uint32_t kStallBothWays = 3;
constexpr uint32_t kAlwaysOn =
    kUsbInterruptBuffers | kUsbInterruptBusReset | kUsbInterruptSetup | kUsbInterruptResume;
constexpr uint32_t kTransactions = kUsbInterruptBuffers | kUsbInterruptSetup;

usb::ControlTransfers transfers;
uint32_t control_data_bit = kBufferData1;
bool suspended = true;
volatile bool is_open = false;

/// Whoever of the two lines has it from now on is asked to send.
void update_line() {
  const bool opened = transfers.is_open() && !suspended;
  if (opened != is_open) {
    is_open = opened;
    pend_line(InterruptLine::kSend);
  }
}

void send_control(usb::Bytes packet) {
  volatile uint8_t* const buffer = usb_buffer(kControlBuffer);
  for (uint8_t i = 0; i < packet.size; ++i) {
    buffer[i] = packet.data[i];
  }
  give_to_usb(usb_memory().buffer[0].in, kBufferFull | control_data_bit | packet.size);
  control_data_bit ^= kBufferData1;
}

/// The controller forgets the stall at the next SETUP.
void stall_control() {
  usb_controller().ep_stall_arm = kStallBothWays;
  usb_memory().buffer[0].in = kBufferStall;
  usb_memory().buffer[0].out = kBufferStall;
}

void take_effect(const usb::Step& step) {
  switch (step.effect) {
    case usb::Effect::kAddress:
      usb_controller().addr_endp[0] = transfers.address();
      break;
    case usb::Effect::kConfigure:
      stop_usb_endpoints();
      if (transfers.is_configured()) {
        start_usb_endpoints();
      }
      break;
    case usb::Effect::kHalt:
      halt_usb_endpoint(step.endpoint, transfers.halted(step.endpoint));
      break;
    case usb::Effect::kNone:
      break;
  }
  update_line();
}

void perform(const usb::Step& step) {
  take_effect(step);
  switch (step.next) {
    case usb::Next::kSend:
      send_control(step.packet);
      break;
    case usb::Next::kReceive:
      give_to_usb(usb_memory().buffer[0].out, kBufferData1 | usb::kControlPacketBytes);
      break;
    case usb::Next::kStall:
      stall_control();
      break;
    case usb::Next::kWait:
      break;
  }
}

void take_setup() {
  usb_controller().sie_status = kUsbStatusSetup;
  usb_memory().buffer[0].in = 0;
  usb_memory().buffer[0].out = 0;
  control_data_bit = kBufferData1;
  const volatile uint8_t* const bytes = usb_buffer(0);
  uint8_t setup[8];
  for (uint8_t i = 0; i < 8; ++i) {
    setup[i] = bytes[i];
  }
  perform(transfers.on_setup(setup));
}

void take_control_packet() {
  uint8_t bytes[usb::kControlPacketBytes];
  const volatile uint8_t* const buffer = usb_buffer(kControlBuffer);
  const uint8_t size = static_cast<uint8_t>(usb_memory().buffer[0].out & kBufferLength);
  for (uint8_t i = 0; i < size && i < sizeof(bytes); ++i) {
    bytes[i] = buffer[i];
  }
  perform(transfers.on_received({bytes, size}));
}

void take_buffers() {
  const uint32_t done = usb_controller().buff_status;
  usb_controller().buff_status = done;
  if ((done & kControlSent) != 0) {
    perform(transfers.on_sent());
  }
  if ((done & kControlReceived) != 0) {
    take_control_packet();
  }
  if ((done & kDataReceived) != 0) {
    on_usb_packet_received();
  }
  if ((done & kDataSent) != 0) {
    on_usb_packet_sent();
  }
}

/// A bus without frames: the host sleeps, or the cable is out. The state lasts, so that it
/// interrupts once only.
void take_suspend() {
  usb_controller().inte = kAlwaysOn;
  suspended = true;
  update_line();
}

/// Begins with the controller's notice, or without it with the first transaction.
void take_resume() {
  usb_controller().sie_status = kUsbStatusResume | kUsbStatusSuspended;
  usb_controller().inte = kAlwaysOn | kUsbInterruptSuspend;
  suspended = false;
  update_line();
}

void take_bus_reset() {
  usb_controller().sie_status = kUsbStatusBusReset;
  usb_controller().addr_endp[0] = 0;
  transfers.on_bus_reset();
  stop_usb_endpoints();
  take_resume();
}

}  // namespace

void start_usb() {
  for (uint32_t word = 0; word < kControlBuffer; word += sizeof(Register)) {
    block_at<Register>(kUsbMemoryAddress + word) = 0;
  }
  usb_controller().muxing = kUsbMuxToPhy | kUsbMuxSoftConnect;
  usb_controller().pwr = kUsbPowerDetected | kUsbPowerOverride;
  usb_controller().main_ctrl = kUsbMainEnable;
  usb_controller().sie_ctrl = kUsbSieControlInterrupt;
  usb_controller().inte = kAlwaysOn;
  enable_line(InterruptLine::kUsb);
  usb_controller().sie_ctrl = kUsbSieControlInterrupt | kUsbSiePullUp;
}

bool usb_line_is_open() { return is_open; }

}  // namespace boards
}  // namespace echomap

extern "C" void on_usb() {
  using namespace echomap::boards;
  const uint32_t causes = usb_controller().ints;
  if ((causes & kUsbInterruptBusReset) != 0) {
    take_bus_reset();
  }
  if (suspended && (causes & kTransactions) != 0) {
    take_resume();
  }
  if ((causes & kUsbInterruptBuffers) != 0) {
    take_buffers();
  }
  if ((causes & kUsbInterruptSetup) != 0) {
    take_setup();
  }
  if ((causes & kUsbInterruptResume) != 0) {
    take_resume();
  }
  if ((causes & kUsbInterruptSuspend) != 0) {
    take_suspend();
  }
}
