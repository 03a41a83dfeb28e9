// SPDX-License-Identifier: MIT
#include <stdint.h>

#include "firmware/boards/cortex_common/stack_paint.hpp"
#include "firmware/boards/cortex_common/vector_table.hpp"
#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"
#include "firmware/hal/interrupts.hpp"

/// What happens between reset and main, and the vector table.
extern "C" {
/// main, which C++ forbids to call by its name.
int run_program() __asm__("main");

/// By the linker script.
extern uint32_t _data_load, _data_start, _data_end, _bss_start, _bss_end, _end, _stack_top;

/// A fault of the core, or an interrupt that nobody enabled: nothing is trusted any more, so the
/// motors go off and the chip is reset.
void on_fault() {
  using namespace echomap::boards;
  cut_motors();
  scb().aircr = kScbAircrResetRequest;
  for (;;) {  // The reset takes some cycles.
    asm volatile("");
  }
}

/// Volatile, because the compiler would make calls of these loops, on a stack that they paint.
void on_reset() {
  echomap::hal::lock_interrupts();
  const volatile uint32_t* from = &_data_load;
  for (volatile uint32_t* to = &_data_start; to != &_data_end; ++to) {
    *to = *from++;
  }
  for (volatile uint32_t* to = &_bss_start; to != &_bss_end; ++to) {
    *to = 0;
  }
  const volatile uint32_t* in_use = nullptr;
  asm volatile("mov %0, sp" : "=r"(in_use));
  for (volatile uint32_t* to = &_end; to != in_use; ++to) {
    *to = echomap::boards::kStackPaint;
  }
  run_program();
}
}

namespace echomap {
namespace boards {
namespace {

constexpr uint8_t kLines = 43;

/// PM0056, figure 12.
constexpr auto make_table() {
  auto table = table_of_faults<kLines>(&_stack_top, on_fault);
  table.set(kResetVector, on_reset);
  table.set(kTickVector, on_sys_tick);
  table.set_line(InterruptLine::kWwdg, on_wwdg);
  for (uint8_t line = 0; line < 5; ++line) {
    table.set_line(static_cast<uint8_t>(InterruptLine::kExti0) + line, on_exti);
  }
  table.set_line(InterruptLine::kExti5To9, on_exti);
  table.set_line(InterruptLine::kExti10To15, on_exti);
  table.set_line(InterruptLine::kTim1Capture, on_tim1_capture);
  table.set_line(InterruptLine::kI2c2Event, on_i2c2_event);
  table.set_line(InterruptLine::kI2c2Error, on_i2c2_error);
  table.set_line(InterruptLine::kUsart1, on_usart1);
  return table;
}

__attribute__((section(".vectors"), used)) constexpr auto vector_table = make_table();

}  // namespace
}  // namespace boards
}  // namespace echomap
