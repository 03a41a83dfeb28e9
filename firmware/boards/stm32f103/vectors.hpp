// SPDX-License-Identifier: MIT
#pragma once

/// The handlers in the vector table of startup.cpp; each stands in the file of its part.
extern "C" {
void on_sys_tick();
void on_wwdg();
void on_exti();
void on_tim1_capture();
void on_i2c2_event();
void on_i2c2_error();
void on_usart1();
}
