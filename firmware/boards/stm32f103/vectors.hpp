// SPDX-License-Identifier: MIT
#pragma once

/// The handlers in the vector table of startup.cpp; each stands in the file of its part.
extern "C" {
void on_sys_tick();
void on_tim1_update();
void on_tim4();
void on_i2c2_event();
void on_i2c2_error();
void on_usart1();
void on_exti15_10();
}
