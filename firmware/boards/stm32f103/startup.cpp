// SPDX-License-Identifier: MIT
#include <stdint.h>

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/stack_paint.hpp"
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

using Handler = void (*)();

constexpr uint8_t kCoreVectors = 16;
constexpr uint8_t kLines = 43;
constexpr uint8_t kResetVector = 1;
constexpr uint8_t kTickVector = 15;

/// PM0056, figure 12: where the stack begins, then a handler for each exception.
struct VectorTable {
  const uint32_t* stack_top;
  Handler handlers[kCoreVectors + kLines - 1];

  constexpr void set(uint8_t vector, Handler handler) { handlers[vector - 1] = handler; }
  constexpr void set(InterruptLine line, Handler handler) {
    set(static_cast<uint8_t>(kCoreVectors + static_cast<uint8_t>(line)), handler);
  }
};

constexpr VectorTable make_table() {
  VectorTable table{};
  table.stack_top = &_stack_top;
  for (uint8_t vector = 1; vector < kCoreVectors + kLines; ++vector) {
    table.set(vector, on_fault);
  }
  table.set(kResetVector, on_reset);
  table.set(kTickVector, on_sys_tick);
  table.set(InterruptLine::kWwdg, on_wwdg);
  table.set(InterruptLine::kTim1Capture, on_tim1_capture);
  table.set(InterruptLine::kI2c2Event, on_i2c2_event);
  table.set(InterruptLine::kI2c2Error, on_i2c2_error);
  table.set(InterruptLine::kUsart1, on_usart1);
  return table;
}

__attribute__((section(".vectors"), used)) constexpr VectorTable vector_table = make_table();

}  // namespace
}  // namespace boards
}  // namespace echomap
