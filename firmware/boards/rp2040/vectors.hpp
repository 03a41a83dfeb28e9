// SPDX-License-Identifier: MIT
#pragma once

/// The handlers in the vector table of startup.cpp; each stands in the file of its part.
extern "C" {
void on_timer0();
void on_timer1();
void on_usb();
void on_pio0();
void on_pins();
void on_uart0();
void on_i2c0();
void on_send();
}
