// SPDX-License-Identifier: MIT
#include "firmware/hal/encoders.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"
#include "firmware/boards/rp2040/quadrature_program.hpp"
#include "firmware/boards/rp2040/vectors.hpp"
#include "firmware/hal/interrupts.hpp"

/// Two state machines of PIO0 run the quadrature program, left and right.
namespace echomap {
namespace boards {
namespace {

constexpr QuadratureProgram kProgram{};
constexpr uint8_t kLeft = 0;
constexpr uint8_t kRight = 1;
constexpr uint32_t kFlags = bit(kLeft) | bit(kRight);

uint32_t read_at_us = 0;
volatile uint16_t left_lost = 0;
volatile uint16_t right_lost = 0;

/// 3.7: in and out shift as the program wants it, and STATUS is all ones while the receive FIFO has
/// less than one word.
void start_machine(uint8_t number, Pin first_pin) {
  constexpr uint32_t kWholeClock = 1U << 16;
  constexpr uint32_t kStatusOfEmptyReceive = bit(4) | 1;
  constexpr uint32_t kWrap = QuadratureProgram::kUp + 2U;
  constexpr uint32_t kOutToTheRight = bit(19);
  StateMachineRegisters& machine = pio0().machine[number];
  machine.clkdiv = kWholeClock;
  machine.execctrl = kWrap << 12 | QuadratureProgram::kTell << 7 | kStatusOfEmptyReceive;
  machine.shiftctrl = kOutToTheRight;
  machine.pinctrl = uint32_t{first_pin} << 15;
  machine.instr = pio::kSetY0;
  machine.instr = pio::kMovOsrPins;
  machine.instr = pio::jmp(QuadratureProgram::kTell);
}

/// What waits in the FIFO may be old; the next word comes within a round.
int16_t count_of(uint8_t machine) {
  const uint32_t empty = bit(static_cast<uint8_t>(kPioReceiveEmptyShift + machine));
  static_cast<void>(pio0().rxf[machine]);
  for (uint8_t polls = 100; polls != 0 && (pio0().fstat & empty) != 0; --polls) {
  }
  return static_cast<int16_t>(pio0().rxf[machine]);
}

}  // namespace

void start_encoders() {
  for (uint8_t pin = kLeftEncoderPin; pin < kRightEncoderPin + 2; ++pin) {
    pull_up(pin);
  }
  for (uint8_t i = 0; i < QuadratureProgram::kWords; ++i) {
    pio0().instr_mem[i] = kProgram.word[i];
  }
  start_machine(kLeft, kLeftEncoderPin);
  start_machine(kRight, kRightEncoderPin);
  pio0().irq0_inte = kFlags << kPioFlagShift;
  enable_line(InterruptLine::kPio0);
  pio0().ctrl = kFlags;
}

}  // namespace boards

namespace hal {

EncoderReading read_encoders() {
  using namespace boards;
  const int16_t left = count_of(kLeft);
  const int16_t right = count_of(kRight);
  read_at_us = timer().timerawl;
  return {left, right};
}

uint32_t encoders_read_at_us() { return boards::read_at_us; }

LostSteps lost_encoder_steps() {
  const InterruptLock lock;
  return {boards::left_lost, boards::right_lost};
}

bool encoders_tell_lost_steps() { return true; }

}  // namespace hal
}  // namespace echomap

extern "C" void on_pio0() {
  using namespace echomap::boards;
  const uint32_t raised = pio0().irq & kFlags;
  pio0().irq = raised;
  if ((raised & bit(kLeft)) != 0) {
    left_lost = static_cast<uint16_t>(left_lost + 1);
  }
  if ((raised & bit(kRight)) != 0) {
    right_lost = static_cast<uint16_t>(right_lost + 1);
  }
}
