// SPDX-License-Identifier: MIT
#include <stdint.h>

#include "firmware/boards/cortex_common/stack_paint.hpp"
#include "firmware/boards/cortex_common/vector_table.hpp"
#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/vectors.hpp"
#include "firmware/hal/interrupts.hpp"

/// What happens between boot2 and main, and the vector tables. The program is copied to RAM and
/// runs there: an instruction takes the same time always, which it does not from a serial flash
/// behind a cache.
extern "C" {
/// main, which C++ forbids to call by its name.
int run_program() __asm__("main");

/// By the linker script.
extern uint32_t _code_load, _code_start, _code_end, _data_load, _data_start, _data_end, _bss_start,
    _bss_end, _end, _stack_top;

/// A fault of the core, or an interrupt that nobody enabled: nothing is trusted any more.
void on_fault() {
  echomap::boards::cut_motors();
  echomap::boards::reset_chip();
}

/// The only code that runs in the flash. Volatile, because the compiler would make calls of these
/// loops, of functions that are not in RAM yet, on a stack that they paint.
__attribute__((section(".start"), used)) void on_reset() {
  asm volatile("cpsid i" ::: "memory");
  const volatile uint32_t* from = &_code_load;
  for (volatile uint32_t* to = &_code_start; to != &_code_end; ++to) {
    *to = *from++;
  }
  from = &_data_load;
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
  echomap::boards::scb().vtor = reinterpret_cast<uint32_t>(&_code_start);
  // Not by a call, which would bring all of the program here.
  asm volatile("bx %0" ::"r"(run_program));
  __builtin_unreachable();
}
}

namespace echomap {
namespace boards {
namespace {

constexpr uint8_t kLines = 32;

constexpr auto make_table() {
  auto table = table_of_faults<kLines>(&_stack_top, on_fault);
  table.set_line(InterruptLine::kTimer0, on_timer0);
  table.set_line(InterruptLine::kTimer1, on_timer1);
  table.set_line(InterruptLine::kUsb, on_usb);
  table.set_line(InterruptLine::kPio0, on_pio0);
  table.set_line(InterruptLine::kPins, on_pins);
  table.set_line(InterruptLine::kUart0, on_uart0);
  table.set_line(InterruptLine::kI2c0, on_i2c0);
  table.set_line(InterruptLine::kSend, on_send);
  return table;
}

__attribute__((section(".vectors"), used)) constexpr auto vector_table = make_table();

/// What boot2 starts the program by.
__attribute__((section(".first_vectors"), used)) constexpr VectorTable<1> first_vectors{&_stack_top,
                                                                                        {on_reset}};

}  // namespace
}  // namespace boards
}  // namespace echomap
