// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/usb_descriptors.hpp"

namespace echomap {
namespace boards {

/// The bytes of the buffer at an offset in the memory shared with the controller.
volatile uint8_t* usb_buffer(uint32_t offset);
/// Hands a buffer to the controller: `state` is its length, its DATA bit, and kBufferFull to send.
void give_to_usb(volatile uint32_t& buffer, uint32_t state);

/// The bulk endpoints and the notifications, as far as the host has come: off before it has
/// configured the device.
void start_usb_endpoints();
void stop_usb_endpoints();
/// Makes one of them refuse, or work again from DATA0 on. As in its descriptor.
void halt_usb_endpoint(uint8_t endpoint, bool halted);
/// The packet to the host has gone, one from it has come.
void on_usb_packet_sent();
void on_usb_packet_received();

}  // namespace boards
}  // namespace echomap
