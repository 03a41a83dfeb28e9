// SPDX-License-Identifier: MIT
#include "firmware/hal/twi.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"

namespace echomap {
namespace boards {
namespace {

using hal::TwiState;

constexpr uint32_t kBitsPerS = 400000;
constexpr uint32_t kLongestRiseNs = 300;  ///< Of the bus in fast mode.
/// What is left of CR1 and CR2 between transfers.
constexpr uint32_t kOn = kI2cCr1Enable;
constexpr uint32_t kInterrupts = kI2cCr2ErrorInterrupt | kI2cCr2EventInterrupt;

volatile TwiState state = TwiState::kIdle;
bool on;
bool reads;
bool turned_round;  ///< The device has its register and is asked to speak.
bool value_is_sent;
uint8_t address_byte;
uint8_t register_byte;
uint8_t value_byte;
volatile int16_t answer;

/// APB1 has half of the core's clock, or where the crystal does not run all of it.
uint32_t bus_clock_hz() { return clock_hz() > 36000000 ? clock_hz() / 2 : clock_hz(); }

void wait_half_clock() {
  constexpr uint32_t kHalfUs = 10;
  const uint32_t start = now_half_us();
  while (now_half_us() - start <= kHalfUs) {
  }
}

/// A device that was given up in the middle of a byte holds SDA low until it has sent the rest of
/// it: nine clocks at most, then it finds no acknowledge (NXP UM10204, 3.1.16).
void free_bus() {
  set_level(kTwiClockPin, true);
  set_mode(kTwiClockPin, PinMode::kOutputOpenDrain);
  for (uint8_t clocks = 9; clocks != 0 && !level_of(kTwiDataPin); --clocks) {
    set_level(kTwiClockPin, false);
    wait_half_clock();
    set_level(kTwiClockPin, true);
    wait_half_clock();
  }
}

void take_bus() {
  free_bus();
  set_mode(kTwiClockPin, PinMode::kAlternateOpenDrain);
  set_mode(kTwiDataPin, PinMode::kAlternateOpenDrain);
  const uint32_t mhz = bus_clock_hz() / 1000000;
  i2c2().cr1 = kI2cCr1Reset;
  i2c2().cr1 = 0;
  i2c2().cr2 = mhz;
  i2c2().ccr = kI2cCcrFast | (bus_clock_hz() + 3 * kBitsPerS - 1) / (3 * kBitsPerS);
  i2c2().trise = mhz * kLongestRiseNs / 1000 + 1;
  i2c2().cr1 = kOn;
  enable_line(InterruptLine::kI2c2Event, kEventPriority);
  enable_line(InterruptLine::kI2c2Error, kEventPriority);
  on = true;
}

void start(uint8_t address, uint8_t device_register) {
  if (!on) {
    take_bus();
  }
  address_byte = static_cast<uint8_t>(address << 1);
  register_byte = device_register;
  turned_round = false;
  value_is_sent = false;
  state = TwiState::kBusy;
  i2c2().cr2 |= kInterrupts;
  i2c2().cr1 = kOn | kI2cCr1Start;
}

void finish(TwiState outcome) {
  i2c2().cr2 &= ~kInterrupts;
  i2c2().cr1 = kOn | kI2cCr1Stop;
  state = outcome;
}

/// The device has heard its address: of two bytes that it may now send the second is the last.
void take_address_answer() {
  static_cast<void>(i2c2().sr2);  // With SR1 this clears ADDR: the bus goes on.
  if (turned_round) {
    i2c2().cr1 = kOn | kI2cCr1SecondByte;
  } else {
    i2c2().dr = register_byte;
  }
}

/// All that was to be sent is sent, or both bytes are here.
void take_end_of_byte() {
  if (turned_round) {
    finish(TwiState::kDone);
    const uint32_t high = i2c2().dr;
    answer = static_cast<int16_t>(high << 8 | i2c2().dr);
  } else if (reads) {
    turned_round = true;
    i2c2().cr1 = kOn | kI2cCr1Start | kI2cCr1Acknowledge | kI2cCr1SecondByte;
  } else if (!value_is_sent) {
    value_is_sent = true;
    i2c2().dr = value_byte;
  } else {
    finish(TwiState::kDone);
  }
}

/// RM0008, figures 273 and 275, and section 26.3.3 on two bytes.
void take_event() {
  if ((i2c2().cr1 & kI2cCr1Start) != 0) {
    return;  // The end of the byte before it still shows.
  }
  const uint32_t status = i2c2().sr1;
  if ((status & kI2cSr1Started) != 0) {
    i2c2().dr = turned_round ? address_byte | 1U : address_byte;
  } else if ((status & kI2cSr1Address) != 0) {
    take_address_answer();
  } else if ((status & kI2cSr1EndOfByte) != 0) {
    take_end_of_byte();
  }
}

}  // namespace
}  // namespace boards

namespace hal {

bool has_twi() { return true; }

void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value) {
  boards::reads = false;
  boards::value_byte = value;
  boards::start(address, device_register);
}

void start_twi_read(uint8_t address, uint8_t device_register) {
  boards::reads = true;
  boards::start(address, device_register);
}

TwiState twi_state(int16_t& value) {
  const TwiState state = boards::state;
  if (state == TwiState::kDone) {
    value = boards::answer;
  }
  return state;
}

void stop_twi() {
  if (!boards::on) {
    return;
  }
  boards::i2c2().cr2 = 0;
  boards::i2c2().cr1 = 0;
  boards::pull_up(boards::kTwiClockPin);
  boards::pull_up(boards::kTwiDataPin);
  boards::on = false;
  boards::state = TwiState::kIdle;
}

}  // namespace hal
}  // namespace echomap

extern "C" {
void on_i2c2_event() { echomap::boards::take_event(); }

/// No answer, or a bus that does what it must not.
void on_i2c2_error() {
  echomap::boards::i2c2().sr1 = 0;
  echomap::boards::finish(echomap::hal::TwiState::kFailed);
}
}
