// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/register.hpp"

/// The USB controller as a device: RP2040 data sheet, 4.1.
namespace echomap {
namespace boards {

/// Two words of an endpoint, to the host and from it.
struct EndpointPair {
  Register in, out;
};

/// The memory that controller and core share, 4.1.2.5: how the endpoints 1 .. 15 are set up, the
/// buffers' states, the buffers.
struct UsbMemory {
  Register setup[2];
  EndpointPair control[15];
  EndpointPair buffer[16];
};
constexpr uint32_t kUsbMemoryAddress = 0x50100000;
constexpr uint32_t kUsbMemoryBytes = 4096;
inline UsbMemory& usb_memory() { return block_at<UsbMemory>(kUsbMemoryAddress); }

/// Where the buffers are in that memory; that of endpoint 0 is the controller's choice.
constexpr uint32_t kControlBuffer = 0x100;
constexpr uint32_t kNotificationBuffer = 0x180;
constexpr uint32_t kSendBuffer = 0x1C0;
constexpr uint32_t kReceiveBuffer = 0x200;

/// Bits of an endpoint's control word; the type stands from bit 26 on, as in descriptors.
constexpr uint32_t kEndpointEnable = bit(31);
constexpr uint32_t kEndpointInterrupt = bit(29);
constexpr uint8_t kEndpointTypeShift = 26;

/// Bits of a buffer's state.
constexpr uint32_t kBufferFull = bit(15);
constexpr uint32_t kBufferData1 = bit(13);
constexpr uint32_t kBufferStall = bit(11);
constexpr uint32_t kBufferAvailable = bit(10);
constexpr uint32_t kBufferLength = 0x3FF;

/// The controller's registers, 4.1.4.
struct UsbRegisters {
  Register addr_endp[16], main_ctrl, sof_wr, sof_rd, sie_ctrl, sie_status, int_ep_ctrl, buff_status,
      buff_cpu_should_handle, ep_abort, ep_abort_done, ep_stall_arm, nak_poll, ep_status_stall_nak,
      muxing, pwr, phy_direct, phy_direct_override, phy_trim, reserved_88, intr, inte, intf, ints;
};
inline UsbRegisters& usb_controller() { return block_at<UsbRegisters>(0x50110000); }

/// Their bits, by register.
constexpr uint32_t kUsbMainEnable = bit(0);
constexpr uint32_t kUsbSiePullUp = bit(16);
constexpr uint32_t kUsbSieControlInterrupt = bit(29);
constexpr uint32_t kUsbStatusResume = bit(11);
constexpr uint32_t kUsbStatusSuspended = bit(4);
constexpr uint32_t kUsbStatusSetup = bit(17);
constexpr uint32_t kUsbStatusBusReset = bit(19);
constexpr uint32_t kUsbMuxToPhy = bit(0);
constexpr uint32_t kUsbMuxSoftConnect = bit(3);
constexpr uint32_t kUsbPowerDetected = bit(2);
constexpr uint32_t kUsbPowerOverride = bit(3);
constexpr uint32_t kUsbInterruptBuffers = bit(4);
constexpr uint32_t kUsbInterruptBusReset = bit(12);
constexpr uint32_t kUsbInterruptSuspend = bit(14);
constexpr uint32_t kUsbInterruptResume = bit(15);
constexpr uint32_t kUsbInterruptSetup = bit(16);

}  // namespace boards
}  // namespace echomap
