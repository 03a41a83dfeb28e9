// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace boards {

/// True while a program on the host has the USB serial port open: the line to the host is then USB,
/// and otherwise the serial port.
bool usb_line_is_open();
/// Sends the next packet, unless one is still under way. Of interrupts only.
void send_over_usb();
/// Once a tick: lets the host send the next packet. One a millisecond is what the program takes for
/// sure; the host holds back the rest.
void take_next_usb_packet();

}  // namespace boards
}  // namespace echomap
